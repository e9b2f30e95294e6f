/**
 * ROS 2 over {@link org.urbi.ros.rtps}: names of topics and types as DDS sees them, what makes this
 * program a node in everybody's graph, topics and services.
 */
@NullMarked
package org.urbi.ros.two;

import org.jspecify.annotations.NullMarked;
