/**
 * The standard library, put together: the only package that knows all of its rooms. Each room has
 * one class for each type of the manual, whose static methods are the slots of its prototype,
 * beside the Java class of its values; classes that are not named after a type help several of
 * them.
 */
@NullMarked
package org.urbi.kernel.library;

import org.jspecify.annotations.NullMarked;
