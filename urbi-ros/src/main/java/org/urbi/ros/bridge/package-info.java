/**
 * A server of the protocol of rosbridge (version 2): web pages and programs that talk to ROS by
 * JSON over a WebSocket are served by a node of either ROS.
 */
@NullMarked
package org.urbi.ros.bridge;

import org.jspecify.annotations.NullMarked;
