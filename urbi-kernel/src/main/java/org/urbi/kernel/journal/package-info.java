/**
 * A run written down, and run again: what the kernel thread gets to know of the outside, in the one
 * order (docs/tools.md, "Recording a run").
 */
@NullMarked
package org.urbi.kernel.journal;

import org.jspecify.annotations.NullMarked;
