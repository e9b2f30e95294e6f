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

  /** The permission for builtins that do not set their own; by default the highest. */
  Permission needs() default Permission.OWNER;
}
