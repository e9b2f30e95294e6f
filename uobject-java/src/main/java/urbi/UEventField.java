package urbi;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Binds a field of a {@link UObject} that is a {@link UEvent}, as {@link UObject#UBindEvent} does,
 * when the object has been constructed; one that is null is made.
 */
@Documented
@Target(ElementType.FIELD)
@Retention(RetentionPolicy.RUNTIME)
public @interface UEventField {
  /** The name in urbiscript; by default that of the field. */
  String value() default "";
}
