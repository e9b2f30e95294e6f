package urbi;

import java.util.Locale;

/** How the data of a {@link UImage} are to be read. */
public enum UImageFormat {
  IMAGE_UNKNOWN("unknown"),
  /** Red, green, blue: 3 bytes for each pixel. */
  IMAGE_RGB("rgb"),
  /** Luminance, blue and red difference: 3 bytes for each pixel, full range. */
  IMAGE_YCbCr("YCbCr"),
  /** A JPEG file. */
  IMAGE_JPEG("jpeg"),
  /** A PPM file, variant P6. */
  IMAGE_PPM("ppm"),
  /** Two pixels in four bytes: Y, U, Y, V; also known as YUYV. */
  IMAGE_YUV422("yuv422"),
  /** One byte for each pixel. */
  IMAGE_GREY8("grey8"),
  /**
   * Two pixels in each byte, the first in the upper half; rows follow one another without a gap.
   */
  IMAGE_GREY4("grey4"),
  /** All Y, then the U and the V of each four neighbours in a row. */
  IMAGE_YUV411_PLANAR("yuv411planar"),
  /** All Y, then U and V in turn, one pair for each two by two pixels. */
  IMAGE_NV12("nv12"),
  /** All Y, then all U, then all V, one of each for two by two pixels. */
  IMAGE_YUV420_PLANAR("yuv420planar");

  /** Another name of {@link #IMAGE_YCbCr}. */
  public static final UImageFormat IMAGE_YUV = IMAGE_YCbCr;

  private final String text;

  UImageFormat(String text) {
    this.text = text;
  }

  /** The word that starts the header of a binary of that format. */
  public String format_string() {
    return text;
  }

  /**
   * The format that a header's first word stands for, in capitals or not; {@link #IMAGE_UNKNOWN}
   * for others.
   */
  public static UImageFormat parse(String word) {
    return switch (word.toLowerCase(Locale.ROOT)) {
      case "rgb" -> IMAGE_RGB;
      case "ycbcr", "ycrcb", "yuv" -> IMAGE_YCbCr;
      case "jpeg", "jpg" -> IMAGE_JPEG;
      case "ppm" -> IMAGE_PPM;
      case "yuv422", "yuyv" -> IMAGE_YUV422;
      case "grey8" -> IMAGE_GREY8;
      case "grey4" -> IMAGE_GREY4;
      case "yuv411planar", "yuv411_planar" -> IMAGE_YUV411_PLANAR;
      case "nv12" -> IMAGE_NV12;
      case "yuv420planar", "yuv420_planar" -> IMAGE_YUV420_PLANAR;
      default -> IMAGE_UNKNOWN;
    };
  }
}
