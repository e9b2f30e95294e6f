package urbi;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Has a method of a {@link UObject} called periodically, as {@link UObject#USetTimer} does. */
@Documented
@Target(ElementType.METHOD)
@Retention(RetentionPolicy.RUNTIME)
public @interface Every {
  /** The period in milliseconds. */
  double value();

  /** Whether it is called after a pass of urbiscript code, as {@link UObject#update} is. */
  boolean afterPass() default false;
}
