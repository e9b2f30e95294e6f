package org.urbi.sim.vision;

import org.opencv.core.Mat;
import org.opencv.core.MatOfByte;
import org.opencv.core.MatOfInt;
import org.opencv.imgcodecs.Imgcodecs;
import org.opencv.imgproc.Imgproc;
import urbi.UConversion;
import urbi.UImage;
import urbi.UImageFormat;

/**
 * Converts rendered images to the requested format: YCbCr and JPEG with OpenCV where there is one,
 * everything else, and without it, by {@link UConversion}.
 */
public final class ImageCoder {
  private ImageCoder() {}

  /**
   * An image of a format.
   *
   * @param quality of JPEG, from 0 to 100
   */
  public static UImage encode(byte[] rgb, int width, int height, UImageFormat format, int quality) {
    boolean openCv = OpenCv.isAvailable();
    return switch (format) {
      case IMAGE_RGB -> new UImage(format, width, height, rgb);
      case IMAGE_JPEG ->
          new UImage(
              format,
              width,
              height,
              openCv
                  ? jpeg(rgb, width, height, quality)
                  : UConversion.convertRGBtoJPEG(rgb, width, height, quality));
      case IMAGE_YCbCr ->
          new UImage(
              format,
              width,
              height,
              openCv ? yCbCr(rgb, width, height) : UConversion.convertRGBtoYCbCr(rgb));
      default -> {
        UImage other = new UImage(format, width, height, new byte[0]);
        UConversion.convert(new UImage(UImageFormat.IMAGE_RGB, width, height, rgb), other);
        yield other;
      }
    };
  }

  /** The image as red, green and blue, whatever format it has. */
  public static UImage toRgb(UImage image) {
    if (image.getImageFormat() == UImageFormat.IMAGE_RGB) {
      return image;
    }
    UImage rgb = new UImage();
    rgb.setImageFormat(UImageFormat.IMAGE_RGB);
    UConversion.convert(image, rgb);
    return rgb;
  }

  static byte[] jpeg(byte[] rgb, int width, int height, int quality) {
    Mat image = OpenCv.matrix(rgb, width, height);
    Imgproc.cvtColor(image, image, Imgproc.COLOR_RGB2BGR);
    MatOfByte encoded = new MatOfByte();
    Imgcodecs.imencode(
        ".jpg", image, encoded, new MatOfInt(Imgcodecs.IMWRITE_JPEG_QUALITY, quality));
    byte[] bytes = encoded.toArray();
    image.release();
    encoded.release();
    return bytes;
  }

  static byte[] yCbCr(byte[] rgb, int width, int height) {
    Mat image = OpenCv.matrix(rgb, width, height);
    Imgproc.cvtColor(image, image, Imgproc.COLOR_RGB2YCrCb);
    byte[] bytes = UConversion.convertYCrCbtoYCbCr(OpenCv.bytes(image));
    image.release();
    return bytes;
  }
}
