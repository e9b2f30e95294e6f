package urbi.media;

import java.util.Locale;

/** How the bytes of an image are to be read. */
public enum ImageFormat {
  UNKNOWN("unknown"),
  /** Red, green, blue: 3 bytes for each pixel. */
  RGB("rgb"),
  /** Luminance, blue and red difference: 3 bytes for each pixel, full range. */
  YCBCR("YCbCr"),
  /** A JPEG file. */
  JPEG("jpeg"),
  /** A PPM file, variant P6. */
  PPM("ppm"),
  /** Two pixels in four bytes: Y, U, Y, V; also known as YUYV. */
  YUV422("yuv422"),
  /** One byte for each pixel. */
  GREY8("grey8"),
  /** Two pixels in each byte, the first in the upper half; rows follow without a gap. */
  GREY4("grey4"),
  /** All Y, then the U and the V of each four neighbours in a row. */
  YUV411_PLANAR("yuv411planar"),
  /** All Y, then U and V in turn, one pair for each two by two pixels. */
  NV12("nv12"),
  /** All Y, then all U, then all V, one of each for two by two pixels. */
  YUV420_PLANAR("yuv420planar");

  private final String keyword;

  ImageFormat(String keyword) {
    this.keyword = keyword;
  }

  /** The word that starts the header of a binary of that format. */
  public String keyword() {
    return keyword;
  }

  /** The format of a keyword, in capitals or not; {@link #UNKNOWN} for others. */
  public static ImageFormat of(String keyword) {
    return switch (keyword.toLowerCase(Locale.ROOT)) {
      case "rgb" -> RGB;
      case "ycbcr", "ycrcb", "yuv" -> YCBCR;
      case "jpeg", "jpg" -> JPEG;
      case "ppm" -> PPM;
      case "yuv422", "yuyv" -> YUV422;
      case "grey8" -> GREY8;
      case "grey4" -> GREY4;
      case "yuv411planar", "yuv411_planar" -> YUV411_PLANAR;
      case "nv12" -> NV12;
      case "yuv420planar", "yuv420_planar" -> YUV420_PLANAR;
      default -> UNKNOWN;
    };
  }
}
