package urbi;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Has a method of a {@link UObject} called before each access to a variable, as {@link
 * UObject#UNotifyAccess} does.
 */
@Documented
@Target(ElementType.METHOD)
@Retention(RetentionPolicy.RUNTIME)
public @interface OnAccess {
  /** The slot of a bound field of the object, or the full name of another variable. */
  String value();
}
