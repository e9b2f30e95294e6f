/**
 * ROS 1: a node that registers with a master by XML-RPC, and exchanges messages with others by
 * TCPROS. Each connection has a thread that may wait for its peer, and for nobody else.
 */
@NullMarked
package org.urbi.ros.one;

import org.jspecify.annotations.NullMarked;
