package urbi;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Binds a method of a {@link UObject}, as {@link UObject#UBindFunction} does, when the object has
 * been constructed.
 */
@Documented
@Target(ElementType.METHOD)
@Retention(RetentionPolicy.RUNTIME)
public @interface UFunction {
  /** The name in urbiscript; by default that of the method. */
  String value() default "";

  /** Whether calls run on a thread of their own. */
  boolean threaded() default false;

  /** Which calls exclude one another; only for threaded ones. */
  LockMode lock() default LockMode.LOCK_NONE;

  /** How many calls there may be at a time, the others are dropped; 0 for any number. */
  int queue() default 0;
}
