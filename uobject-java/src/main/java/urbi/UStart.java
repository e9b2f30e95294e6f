package urbi;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Declares a UObject or a hub of a module, as a static call of {@link UObject#UStart} does. */
@Documented
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.RUNTIME)
public @interface UStart {
  /** The name in urbiscript; by default the simple name of the class. */
  String value() default "";
}
