package urbi;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Has a method of a {@link UObject} called after each change of a variable, as {@link
 * UObject#UNotifyChange} does.
 */
@Documented
@Target(ElementType.METHOD)
@Retention(RetentionPolicy.RUNTIME)
public @interface OnChange {
  /** The slot of a bound field of the object, or the full name of another variable. */
  String value();

  /** Whether calls run on a thread of their own. */
  boolean threaded() default false;

  /** Which calls exclude one another; only for threaded ones. */
  LockMode lock() default LockMode.LOCK_NONE;

  /** How many calls there may be at a time, the others are dropped; 0 for any number. */
  int queue() default 0;
}
