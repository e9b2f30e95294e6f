/** How fast the simulated robot is, beside libode and OpenCV without it. */
@NullMarked
package org.urbi.bench.sim;

import org.jspecify.annotations.NullMarked;
