/** Compiles syntax trees to executable nodes. */
@NullMarked
package org.urbi.kernel.compile;

import org.jspecify.annotations.NullMarked;
