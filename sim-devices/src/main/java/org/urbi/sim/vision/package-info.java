/**
 * What can be seen in images, with OpenCV, which comes with native code for the usual machines. It
 * is loaded when it is needed first; images are arrays of red, green and blue.
 */
@NullMarked
package org.urbi.sim.vision;

import org.jspecify.annotations.NullMarked;
