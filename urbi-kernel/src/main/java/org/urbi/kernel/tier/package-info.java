/** Compiles hot code to classes of the Java machine (docs/tier.md). */
@NullMarked
package org.urbi.kernel.tier;

import org.jspecify.annotations.NullMarked;
