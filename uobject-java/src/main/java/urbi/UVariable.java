package urbi;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Binds a field of a {@link UObject} that is a {@link UVar} or an {@link InputPort}, as {@link
 * UObject#UBindVar} does, when the object has been constructed; one that is null is made.
 */
@Documented
@Target(ElementType.FIELD)
@Retention(RetentionPolicy.RUNTIME)
public @interface UVariable {
  /** The name in urbiscript; by default that of the field. */
  String value() default "";

  /** Whether the object owns it, see {@link UObject#UOwned}. */
  boolean owned() default false;
}
