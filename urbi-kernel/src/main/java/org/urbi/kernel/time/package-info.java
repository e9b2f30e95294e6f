/** The sources of time and random numbers; no other code may read a clock. */
@NullMarked
package org.urbi.kernel.time;

import org.jspecify.annotations.NullMarked;
