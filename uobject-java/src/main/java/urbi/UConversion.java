package urbi;

/**
 * Converts images and sounds (manual, "Binary conversion").
 *
 * <p>Colours follow JPEG: BT.601 in full range. All methods throw {@link UConversionException} for
 * data that are too short or no such image or sound.
 */
public final class UConversion {
  private UConversion() {}

  /**
   * Makes an image of another one's, in the format and size that the destination has; a width or
   * height of 0 there is the source's. Colours and size are converted as needed. The destination
   * gets new data.
   */
  public static void convert(UImage source, UImage destination) {
    Pixels pixels = ImageDecoder.decode(source);
    int width = destination.getWidth() == 0 ? pixels.width() : destination.getWidth();
    int height = destination.getHeight() == 0 ? pixels.height() : destination.getHeight();
    UImageFormat format = destination.getImageFormat();
    if (format == source.getImageFormat() && width == pixels.width() && height == pixels.height()) {
      destination.setData(source.getData().clone());
    } else {
      destination.setData(ImageEncoder.encode(pixels.scaled(width, height), format));
    }
    destination.setWidth(width);
    destination.setHeight(height);
  }

  /**
   * Makes a sound of another one's, in the format that the destination has: channels, rate, sample
   * size and sample format are converted as needed, and the source's where they are 0 or null. The
   * destination gets new data.
   */
  public static void convert(USound source, USound destination) {
    SoundConversion.convert(source, destination);
  }

  /** Red, green, blue to luminance, blue and red difference. */
  public static byte[] convertRGBtoYCbCr(byte[] source) {
    return Colours.toYCbCr(source);
  }

  /** Luminance, blue and red difference to red, green, blue. */
  public static byte[] convertYCbCrtoRGB(byte[] source) {
    return Colours.toRgb(source);
  }

  /** Swaps the differences of each pixel; its own inverse. */
  public static byte[] convertYCrCbtoYCbCr(byte[] source) {
    byte[] result = source.clone();
    for (int i = 0; i + 2 < result.length; i += 3) {
      result[i + 1] = source[i + 2];
      result[i + 2] = source[i + 1];
    }
    return result;
  }

  /** Luminance by recommendation 601, one byte for each pixel. */
  public static byte[] convertRGBtoGrey8_601(byte[] source) {
    return Colours.luminance(source);
  }

  /** The image in a JPEG file, with its size. */
  public static UImage convertJPEGtoRGB(byte[] source) {
    return decoded(source, UImageFormat.IMAGE_RGB);
  }

  /** The image in a JPEG file, with its size. */
  public static UImage convertJPEGtoYCrCb(byte[] source) {
    UImage image = decoded(source, UImageFormat.IMAGE_YCbCr);
    image.setData(convertYCrCbtoYCbCr(image.getData()));
    return image;
  }

  private static UImage decoded(byte[] source, UImageFormat format) {
    UImage image = new UImage();
    image.setImageFormat(format);
    convert(new UImage(UImageFormat.IMAGE_JPEG, 0, 0, source), image);
    return image;
  }

  /**
   * A JPEG file of an image.
   *
   * @param quality from 0 to 100
   */
  public static byte[] convertRGBtoJPEG(byte[] source, int width, int height, int quality) {
    Pixels pixels = new Pixels(width, height, false, source);
    pixels.check("rgb");
    return ImageEncoder.jpeg(pixels, quality);
  }

  /**
   * A JPEG file of an image.
   *
   * @param quality from 0 to 100
   */
  public static byte[] convertYCrCbtoJPEG(byte[] source, int width, int height, int quality) {
    Pixels pixels = new Pixels(width, height, true, convertYCrCbtoYCbCr(source));
    pixels.check("YCbCr");
    return ImageEncoder.jpeg(pixels, quality);
  }
}
