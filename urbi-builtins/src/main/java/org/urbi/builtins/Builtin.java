package org.urbi.builtins;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * A method that urbiscript can call: static, or one of a class that is made with what it needs.
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
   * Whether it wants its arguments unevaluated: it has no arguments in Java then and finds them in
   * {@code CallSite.argumentNodes()}.
   */
  boolean lazy() default false;

  /** How few arguments a lazy builtin may have. */
  int min() default 0;

  /** How many arguments a lazy builtin may have; -1 for any number. */
  int max() default -1;

  /**
   * Whether it is called when the slot of that name, which another builtin declares, is assigned;
   * it has one argument then, the value.
   */
  boolean setter() default false;

  /** What a lobby needs to call it; by default what its class says. */
  Permission needs() default Permission.AS_TYPE;
}
