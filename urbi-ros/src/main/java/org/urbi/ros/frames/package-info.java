/**
 * Where things are: the frames of a robot, from what is told on {@code /tf} and {@code /tf_static}.
 */
@NullMarked
package org.urbi.ros.frames;

import org.jspecify.annotations.NullMarked;
