package org.urbi.builtins;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * A final class whose methods are the builtins of one type of the standard library.
 *
 * <p>If they need services of the kernel besides the frame of their caller, the class has one
 * constructor with these services as parameters, each of a type of its own, and instance methods.
 * The code that installs the library passes the services; there is one instance for each kernel.
 *
 * <p>A method {@code newPrototype(World)}, if there is one, creates the prototype of the type; it
 * is needed by types whose values are objects of a Java class of their own. Without it the
 * prototype is a plain object.
 */
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.SOURCE)
public @interface UrbiType {
  /** The name in urbiscript, such as {@code Float}, {@code Float.limits}. */
  String value();

  /** The names of the prototypes in the order of their declaration, first looked up first. */
  String[] protos() default {"Object"};

  /** What the type is, in a sentence. */
  String doc();

  /** The permission for builtins that do not set their own; by default the highest. */
  Permission needs() default Permission.OWNER;
}
