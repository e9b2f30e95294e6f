package org.urbi.sim.vision;

import org.opencv.core.Core;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;
import org.opencv.imgproc.Imgproc;

/**
 * Finds the pixels whose colour is in a range. It keeps its matrices from one image to the next.
 * OpenCV's hues are halves of degrees, its saturations and values bytes.
 */
final class ColourMask {
  private final Mat hsv = new Mat();
  private final Mat mask = new Mat();
  private final Mat other = new Mat();

  /** 255 where the colour is in the range, otherwise 0; valid until the next call. */
  Mat find(Mat rgb, ColourRange range) {
    prepare(rgb);
    return select(range);
  }

  /** Takes the image of which colours are selected next. */
  void prepare(Mat rgb) {
    Imgproc.cvtColor(rgb, hsv, Imgproc.COLOR_RGB2HSV);
  }

  /** As {@link #find}, of the image that was prepared. */
  Mat select(ColourRange range) {
    if (range.minHue() <= range.maxHue()) {
      select(range, range.minHue(), range.maxHue(), mask);
    } else {
      select(range, range.minHue(), 360, mask);
      select(range, 0, range.maxHue(), other);
      Core.bitwise_or(mask, other, mask);
    }
    return mask;
  }

  private void select(ColourRange range, double minHue, double maxHue, Mat into) {
    Core.inRange(
        hsv,
        new Scalar(minHue / 2, range.minSaturation() * 255, range.minValue() * 255),
        new Scalar(maxHue / 2, range.maxSaturation() * 255, range.maxValue() * 255),
        into);
  }
}
