/**
 * ROS 2 by the {@code rcl} of an installation, in C: messages go to it and come from it as the
 * bytes of which they consist, its middleware does the rest.
 */
@NullMarked
package org.urbi.ros.rcl;

import org.jspecify.annotations.NullMarked;
