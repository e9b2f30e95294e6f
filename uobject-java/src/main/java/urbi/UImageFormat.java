package urbi;

import urbi.media.ImageFormat;

/** How the data of a {@link UImage} are to be read. */
public enum UImageFormat {
  IMAGE_UNKNOWN(ImageFormat.UNKNOWN),
  /** Red, green, blue: 3 bytes for each pixel. */
  IMAGE_RGB(ImageFormat.RGB),
  /** Luminance, blue and red difference: 3 bytes for each pixel, full range. */
  IMAGE_YCbCr(ImageFormat.YCBCR),
  /** A JPEG file. */
  IMAGE_JPEG(ImageFormat.JPEG),
  /** A PPM file, variant P6. */
  IMAGE_PPM(ImageFormat.PPM),
  /** Two pixels in four bytes: Y, U, Y, V; also known as YUYV. */
  IMAGE_YUV422(ImageFormat.YUV422),
  /** One byte for each pixel. */
  IMAGE_GREY8(ImageFormat.GREY8),
  /**
   * Two pixels in each byte, the first in the upper half; rows follow one another without a gap.
   */
  IMAGE_GREY4(ImageFormat.GREY4),
  /** All Y, then the U and the V of each four neighbours in a row. */
  IMAGE_YUV411_PLANAR(ImageFormat.YUV411_PLANAR),
  /** All Y, then U and V in turn, one pair for each two by two pixels. */
  IMAGE_NV12(ImageFormat.NV12),
  /** All Y, then all U, then all V, one of each for two by two pixels. */
  IMAGE_YUV420_PLANAR(ImageFormat.YUV420_PLANAR);

  /** Another name of {@link #IMAGE_YCbCr}. */
  public static final UImageFormat IMAGE_YUV = IMAGE_YCbCr;

  private final ImageFormat format;

  UImageFormat(ImageFormat format) {
    this.format = format;
  }

  /** The word that starts the header of a binary of that format. */
  public String format_string() {
    return format.keyword();
  }

  ImageFormat format() {
    return format;
  }

  /**
   * The format that a header's first word stands for, in capitals or not; {@link #IMAGE_UNKNOWN}
   * for others.
   */
  public static UImageFormat parse(String word) {
    ImageFormat wanted = ImageFormat.of(word);
    for (UImageFormat each : values()) {
      if (each.format == wanted) {
        return each;
      }
    }
    return IMAGE_UNKNOWN;
  }
}
