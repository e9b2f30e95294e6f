/** Executable code: nodes, frames, functions, and calls from Java. */
package org.urbi.kernel.node;
