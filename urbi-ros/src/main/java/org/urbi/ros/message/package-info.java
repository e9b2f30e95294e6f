/**
 * What messages are made of: the texts of {@code .msg}, {@code .srv} and {@code .action} files as
 * immutable definitions, what identifies a type to others, and what a value of it looks like.
 */
@NullMarked
package org.urbi.ros.message;

import org.jspecify.annotations.NullMarked;
