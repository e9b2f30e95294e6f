package org.urbi.builtins;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * A method that urbiscript can call: a static method, or an instance method of a class that gets
 * what it needs by its constructor.
 *
 * <p>Its parameters, in this order: optionally the {@code Frame} of the caller; optionally the
 * {@code CallSite}; the target, {@code UrbiObject} or a subclass of it; the arguments. An argument
 * is an {@code UrbiObject} or a subclass of it, or {@code double}, {@code int}, {@code long},
 * {@code boolean}, {@code String}, which are unwrapped. Trailing ones may be {@link Optional}:
 * these are null when absent, so that numbers are boxed. The last may be {@code UrbiObject...}.
 *
 * <p>It returns an {@code UrbiObject}, nothing ({@code void} in urbiscript too), {@code double},
 * {@code int}, {@code long}, {@code boolean}, {@code String}, or a collection of objects, which
 * becomes a List.
 */
@Target(ElementType.METHOD)
@Retention(RetentionPolicy.SOURCE)
public @interface Builtin {
  /** The names in urbiscript; by default that of the method. */
  String[] value() default {};

  /** What it does, in a sentence. */
  String doc();

  /**
   * Whether its arguments are not evaluated: the Java method then has no arguments and finds them
   * in {@code CallSite.argumentNodes()}.
   */
  boolean lazy() default false;

  /** The minimum number of arguments of a lazy builtin. */
  int min() default 0;

  /** The maximum number of arguments of a lazy builtin; -1 for any number. */
  int max() default -1;

  /**
   * Whether it is a setter: it is called, with the value as its only argument, when the slot of
   * that name, which another builtin declares, is assigned.
   */
  boolean setter() default false;

  /** The permission needed to call it; by default that of its class. */
  Permission needs() default Permission.AS_TYPE;
}
