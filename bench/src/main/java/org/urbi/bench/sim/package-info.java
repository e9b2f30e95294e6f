/** How fast the simulated robot is, beside libode and OpenCV without it. */
package org.urbi.bench.sim;
