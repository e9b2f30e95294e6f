/**
 * What urbiscript sees of ROS (manual, "Communication with ROS"): {@code Ros}, {@code Ros.Topic},
 * {@code Ros.Service}. Threads of the network hand over through the SDK, and never more than a
 * topic's {@code depth}; what takes time is promised, so that only the job waits that asks.
 */
@NullMarked
package org.urbi.ros.uobject;

import org.jspecify.annotations.NullMarked;
