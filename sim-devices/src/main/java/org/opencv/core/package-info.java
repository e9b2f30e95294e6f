/** The one class that has to be where OpenCV's own are. */
@NullMarked
package org.opencv.core;

import org.jspecify.annotations.NullMarked;
