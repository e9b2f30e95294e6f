package urbi;

import java.util.function.Supplier;
import urbi.media.Colours;
import urbi.media.ImageFormat;
import urbi.media.MediaException;
import urbi.media.Picture;
import urbi.media.SoundData;

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
    Picture made =
        guarded(() ->
            picture(source)
                .converted(
                    destination.getImageFormat().format(),
                    destination.getWidth(),
                    destination.getHeight()));
    destination.setData(made.data());
    destination.setWidth(made.width());
    destination.setHeight(made.height());
  }

  private static Picture picture(UImage image) {
    return new Picture(
        image.getImageFormat().format(), image.getWidth(), image.getHeight(), image.getData());
  }

  private static <T> T guarded(Supplier<T> conversion) {
    try {
      return conversion.get();
    } catch (MediaException e) {
      throw new UConversionException(e.getMessage(), e);
    }
  }

  /**
   * Makes a sound of another one's, in the format that the destination has: channels, rate, sample
   * size and sample format are converted as needed, and the source's where they are 0 or null. The
   * destination gets new data.
   */
  public static void convert(USound source, USound destination) {
    SoundData made = guarded(() -> recording(source).converted(recording(destination)));
    destination.setChannels(made.channels());
    destination.setRate(made.rate());
    destination.setSampleSize(made.sampleSize());
    destination.setSampleFormat(USoundSampleFormat.of(made.samples()));
    destination.setData(made.data());
  }

  private static SoundData recording(USound sound) {
    USoundSampleFormat samples = sound.getSampleFormat();
    return new SoundData(
        sound.getSoundFormat().format(),
        sound.getChannels(),
        sound.getRate(),
        sound.getSampleSize(),
        samples == null ? null : samples.format(),
        sound.getData());
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
    return guarded(() -> new Picture(ImageFormat.RGB, width, height, source).toJpeg(quality));
  }

  /**
   * A JPEG file of an image.
   *
   * @param quality from 0 to 100
   */
  public static byte[] convertYCrCbtoJPEG(byte[] source, int width, int height, int quality) {
    byte[] ycbcr = convertYCrCbtoYCbCr(source);
    return guarded(() -> new Picture(ImageFormat.YCBCR, width, height, ycbcr).toJpeg(quality));
  }
}
