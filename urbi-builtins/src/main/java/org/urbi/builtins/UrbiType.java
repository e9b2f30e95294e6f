package org.urbi.builtins;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * A final class whose methods are the builtins of one type of the standard library.
 *
 * <p>When they need more of the kernel than the frame of their caller gives, the class has one
 * constructor that asks for it, each thing by a type of its own, and methods that are not static.
 * Who installs the library hands it in; there is one instance for each kernel then.
 *
 * <p>A method {@code newPrototype(World)}, if there is one, makes the object that becomes the
 * prototype of the type; it is needed by types whose values are objects of a Java class of their
 * own. Without it the prototype is a plain object.
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

  /** What a lobby needs to call those of its builtins that do not say it; the most by default. */
  Permission needs() default Permission.OWNER;
}
