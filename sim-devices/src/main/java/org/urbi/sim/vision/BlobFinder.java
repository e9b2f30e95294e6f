package org.urbi.sim.vision;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.opencv.core.Mat;
import org.opencv.core.MatOfPoint;
import org.opencv.imgproc.Imgproc;
import org.opencv.imgproc.Moments;

/** Finds the largest patch of a colour. One thread at a time uses it. */
public final class BlobFinder {
  private final ColourMask colours;
  private final Mat hierarchy;

  /**
   * @throws org.urbi.sim.SimulationException if OpenCV cannot be used
   */
  public BlobFinder() {
    OpenCv.require();
    colours = new ColourMask();
    hierarchy = new Mat();
  }

  /**
   * The largest patch of a colour.
   *
   * @param threshold the least share of the image that counts, from 0 to 1
   */
  public Optional<Blob> find(
      byte[] rgb, int width, int height, ColourRange range, double threshold) {
    Mat image = OpenCv.matrix(rgb, width, height);
    List<MatOfPoint> contours = new ArrayList<>();
    Imgproc.findContours(
        colours.find(image, range),
        contours,
        hierarchy,
        Imgproc.RETR_EXTERNAL,
        Imgproc.CHAIN_APPROX_NONE);
    image.release();
    Moments largest = null;
    for (MatOfPoint contour : contours) {
      Moments moments = Imgproc.moments(contour);
      contour.release();
      // Single pixels and lines have no area, and no centre either.
      if (moments.m00 > 0 && (largest == null || moments.m00 > largest.m00)) {
        largest = moments;
      }
    }
    if (largest == null || largest.m00 < threshold * width * height) {
      return Optional.empty();
    }
    return Optional.of(blob(largest, width, height));
  }

  private static Blob blob(Moments m, int width, int height) {
    double x = m.m10 / m.m00;
    double y = m.m01 / m.m00;
    double xx = m.mu20 / m.m00;
    double yy = m.mu02 / m.m00;
    double xy = m.mu11 / m.m00;
    double spread = Math.sqrt(4 * xy * xy + (xx - yy) * (xx - yy));
    double longer = (xx + yy + spread) / 2;
    double shorter = (xx + yy - spread) / 2;
    return new Blob(
        (x + 0.5) / width - 0.5,
        0.5 - (y + 0.5) / height,
        m.m00 / ((double) width * height),
        shorter > 0 ? Math.sqrt(longer / shorter) : Double.POSITIVE_INFINITY,
        // Rows of the image grow downwards.
        -0.5 * StrictMath.atan2(2 * xy, xx - yy),
        Math.sqrt(m.m00 / Math.PI));
  }
}
