/** Prints syntax trees as text. */
@NullMarked
package org.urbi.lang.print;

import org.jspecify.annotations.NullMarked;
