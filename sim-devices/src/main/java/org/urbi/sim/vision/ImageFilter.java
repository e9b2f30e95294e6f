package org.urbi.sim.vision;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Size;
import org.opencv.imgproc.Imgproc;
import org.urbi.sim.SimulationException;

/** The usual filters: an image in, one of the same size out. One thread at a time uses one. */
public final class ImageFilter {
  /** What it does. */
  public enum Kind {
    /** Luminance. */
    GREY(0, 0, 0),
    /** The negative. */
    INVERT(0, 0, 0),
    /** Left and right exchanged. */
    MIRROR(0, 0, 0),
    /** Top and bottom exchanged. */
    FLIP(0, 0, 0),
    /** The mean around each pixel, weighted by a bell; the parameter is its radius in pixels. */
    BLUR(3, 0.5, 50),
    /** The median around each pixel; the parameter is the radius in pixels. */
    MEDIAN(1, 1, 50),
    /** White where it is brighter than the parameter, from 0 to 1, and black elsewhere. */
    THRESHOLD(0.5, 0, 1),
    /** Contours by Canny; the parameter is the least steepness, from 0 to 1. */
    EDGES(0.2, 0, 1),
    /** How steep the brightness is, by Sobel. */
    GRADIENT(0, 0, 0),
    /** Dark grows; the parameter is by how many pixels. */
    ERODE(1, 1, 50),
    /** Bright grows; the parameter is by how many pixels. */
    DILATE(1, 1, 50),
    /** As much contrast as there can be. */
    EQUALIZE(0, 0, 0),
    /** The difference to the image before: what moves is bright. */
    DIFFERENCE(0, 0, 0);

    private final double standard;
    private final double least;
    private final double most;

    Kind(double standard, double least, double most) {
      this.standard = standard;
      this.least = least;
      this.most = most;
    }

    /** The parameter unless another is given; 0 for those without one. */
    public double standard() {
      return standard;
    }

    /** As urbiscript names it. */
    public String urbiName() {
      return name().toLowerCase(Locale.ROOT);
    }

    /**
     * @throws SimulationException if there is none of that name
     */
    public static Kind named(String name) {
      return Arrays.stream(values())
          .filter(kind -> kind.urbiName().equals(name))
          .findFirst()
          .orElseThrow(() ->
              new SimulationException(
                  "unknown filter '" + name + "'; there are " + String.join(", ", names())));
    }

    /** All names. */
    public static List<String> names() {
      return Arrays.stream(values()).map(Kind::urbiName).toList();
    }
  }

  private final Kind kind;
  private double parameter;
  private byte @Nullable [] before;

  /**
   * @throws SimulationException if OpenCV cannot be used
   */
  public ImageFilter(Kind kind) {
    OpenCv.require();
    this.kind = kind;
    this.parameter = kind.standard();
  }

  public double parameter() {
    return parameter;
  }

  /**
   * @throws SimulationException if it is out of the range of this kind
   */
  public void setParameter(double value) {
    if (kind.most == 0 ? value != 0 : !(value >= kind.least && value <= kind.most)) {
      throw new SimulationException(
          kind.urbiName()
              + (kind.most == 0
                  ? ": takes no parameter"
                  : ": parameter between "
                      + kind.least
                      + " and "
                      + kind.most
                      + " expected, not "
                      + value));
    }
    parameter = value;
  }

  /** Applies it. */
  public byte[] apply(byte[] rgb, int width, int height) {
    Mat image = OpenCv.matrix(rgb, width, height);
    Mat result = new Mat();
    run(image, result, rgb);
    if (result.channels() == 1) {
      Imgproc.cvtColor(result, result, Imgproc.COLOR_GRAY2RGB);
    }
    byte[] bytes = OpenCv.bytes(result);
    image.release();
    result.release();
    return bytes;
  }

  private void run(Mat image, Mat result, byte[] rgb) {
    switch (kind) {
      case GREY -> Imgproc.cvtColor(image, result, Imgproc.COLOR_RGB2GRAY);
      case INVERT -> Core.bitwise_not(image, result);
      case MIRROR -> Core.flip(image, result, 1);
      case FLIP -> Core.flip(image, result, 0);
      case BLUR -> Imgproc.GaussianBlur(image, result, new Size(0, 0), parameter / 2);
      case MEDIAN -> Imgproc.medianBlur(image, result, 2 * (int) parameter + 1);
      case THRESHOLD -> {
        Imgproc.cvtColor(image, result, Imgproc.COLOR_RGB2GRAY);
        Imgproc.threshold(result, result, parameter * 255, 255, Imgproc.THRESH_BINARY);
      }
      case EDGES -> {
        Imgproc.cvtColor(image, result, Imgproc.COLOR_RGB2GRAY);
        Imgproc.Canny(result, result, parameter * 255, parameter * 510);
      }
      case GRADIENT -> gradient(image, result);
      case ERODE -> Imgproc.erode(image, result, disc());
      case DILATE -> Imgproc.dilate(image, result, disc());
      case EQUALIZE -> {
        Imgproc.cvtColor(image, result, Imgproc.COLOR_RGB2GRAY);
        Imgproc.equalizeHist(result, result);
      }
      case DIFFERENCE -> {
        byte[] other = before == null || before.length != rgb.length ? rgb : before;
        Mat last = OpenCv.matrix(other, image.cols(), image.rows());
        Core.absdiff(image, last, result);
        last.release();
        before = rgb.clone();
      }
    }
  }

  private Mat disc() {
    double size = 2 * (int) parameter + 1;
    return Imgproc.getStructuringElement(Imgproc.MORPH_ELLIPSE, new Size(size, size));
  }

  private static void gradient(Mat image, Mat result) {
    Mat grey = new Mat();
    Mat across = new Mat();
    Mat down = new Mat();
    Imgproc.cvtColor(image, grey, Imgproc.COLOR_RGB2GRAY);
    Imgproc.Sobel(grey, across, CvType.CV_16S, 1, 0);
    Imgproc.Sobel(grey, down, CvType.CV_16S, 0, 1);
    Core.convertScaleAbs(across, across);
    Core.convertScaleAbs(down, down);
    Core.addWeighted(across, 0.5, down, 0.5, 0, result);
    grey.release();
    across.release();
    down.release();
  }
}
