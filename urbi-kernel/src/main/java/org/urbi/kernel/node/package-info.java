/** Executable code: nodes, frames, functions, and calls from Java. */
@NullMarked
package org.urbi.kernel.node;

import org.jspecify.annotations.NullMarked;
