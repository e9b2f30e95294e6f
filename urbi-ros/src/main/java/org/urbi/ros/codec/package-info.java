/**
 * Messages as bytes: the serialization of ROS 1, and CDR (its first version, of either byte order)
 * for ROS 2. What is to be sent is checked while it is written, so that nothing wrong is ever sent;
 * of what comes nothing is believed.
 */
@NullMarked
package org.urbi.ros.codec;

import org.jspecify.annotations.NullMarked;
