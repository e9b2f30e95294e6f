/** What {@code bench/ros} measures, beside rospy and roscpp. */
@NullMarked
package org.urbi.bench.ros;

import org.jspecify.annotations.NullMarked;
