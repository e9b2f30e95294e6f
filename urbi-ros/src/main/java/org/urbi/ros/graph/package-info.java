/**
 * What both versions of ROS have in common, as those see it who use them: a node, its topics and
 * its services. Whatever waits for the network is answered later, on a thread of the network.
 */
@NullMarked
package org.urbi.ros.graph;

import org.jspecify.annotations.NullMarked;
