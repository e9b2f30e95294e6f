package org.urbi.builtins;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** A final class with more builtins of a type that another class declares by {@link UrbiType}. */
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.SOURCE)
public @interface UrbiTypePart {
  /** The name of the type in urbiscript. */
  String value();

  /** What a lobby needs to call those of its builtins that do not say it; the most by default. */
  Permission needs() default Permission.OWNER;
}
