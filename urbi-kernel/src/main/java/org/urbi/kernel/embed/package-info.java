/** The kernel as a library: evaluation, calls and listeners from any thread of a Java program. */
@NullMarked
package org.urbi.kernel.embed;

import org.jspecify.annotations.NullMarked;
