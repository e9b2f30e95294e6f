package urbi;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class UConversionTest {
  /** A soft gradient, of an odd size, so that every format keeps it nearly. */
  private static UImage gradient(int width, int height) {
    byte[] data = new byte[3 * width * height];
    int at = 0;
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        data[at++] = (byte) (60 + 100 * x / width);
        data[at++] = (byte) (60 + 100 * y / height);
        data[at++] = (byte) (120 + 40 * x / width);
      }
    }
    return new UImage(UImageFormat.IMAGE_RGB, width, height, data);
  }

  private static UImage converted(UImage source, UImageFormat format) {
    UImage result = new UImage();
    result.setImageFormat(format);
    UConversion.convert(source, result);
    return result;
  }

  private static int worst(byte[] a, byte[] b) {
    assertEquals(a.length, b.length);
    int worst = 0;
    for (int i = 0; i < a.length; i++) {
      worst = Math.max(worst, Math.abs((a[i] & 0xff) - (b[i] & 0xff)));
    }
    return worst;
  }

  private static byte[] bytes(int... values) {
    byte[] bytes = new byte[values.length];
    for (int i = 0; i < values.length; i++) {
      bytes[i] = (byte) values[i];
    }
    return bytes;
  }

  @ParameterizedTest
  @CsvSource({
    "IMAGE_RGB, 0, 3003",
    "IMAGE_PPM, 0, 3016",
    "IMAGE_YCbCr, 2, 3003",
    "IMAGE_YUV422, 5, 2024",
    "IMAGE_NV12, 8, 1553",
    "IMAGE_YUV420_PLANAR, 8, 1553",
    "IMAGE_YUV411_PLANAR, 9, 1507",
    "IMAGE_JPEG, 14, 0"
  })
  void roundTrip(UImageFormat format, int tolerance, int size) {
    UImage source = gradient(91, 11);
    UImage there = converted(source, format);
    assertEquals(91, there.getWidth());
    assertEquals(11, there.getHeight());
    if (size > 0) {
      assertEquals(size, there.getSize());
    }
    UImage back = converted(there, UImageFormat.IMAGE_RGB);
    assertEquals(91, back.getWidth());
    assertEquals(11, back.getHeight());
    assertTrue(worst(source.getData(), back.getData()) <= tolerance);
  }

  @ParameterizedTest
  @EnumSource(
      value = UImageFormat.class,
      mode = EnumSource.Mode.EXCLUDE,
      names = {"IMAGE_UNKNOWN"})
  void everyFormatBecomesEveryOther(UImageFormat from) {
    UImage source = converted(gradient(16, 8), from);
    for (UImageFormat to : UImageFormat.values()) {
      if (to != UImageFormat.IMAGE_UNKNOWN) {
        UImage there = converted(source, to);
        byte[] expected = converted(source, UImageFormat.IMAGE_GREY8).getData();
        int tolerance = to == UImageFormat.IMAGE_GREY4 || from == UImageFormat.IMAGE_GREY4 ? 12 : 8;
        assertTrue(
            worst(expected, converted(there, UImageFormat.IMAGE_GREY8).getData()) <= tolerance);
      }
    }
  }

  @Test
  void knownColours() {
    byte[] rgb = bytes(255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0);
    assertArrayEquals(
        bytes(76, 85, 255, 150, 44, 21, 29, 255, 107, 255, 128, 128, 0, 128, 128),
        UConversion.convertRGBtoYCbCr(rgb));
    assertTrue(worst(rgb, UConversion.convertYCbCrtoRGB(UConversion.convertRGBtoYCbCr(rgb))) <= 1);
    assertArrayEquals(bytes(76, 150, 29, 255, 0), UConversion.convertRGBtoGrey8_601(rgb));
    assertArrayEquals(
        bytes(1, 3, 2, 4, 6, 5), UConversion.convertYCrCbtoYCbCr(bytes(1, 2, 3, 4, 5, 6)));
  }

  @Test
  void knownLayouts() {
    UImage image =
        new UImage(
            UImageFormat.IMAGE_YCbCr,
            2,
            2,
            bytes(10, 100, 200, 20, 110, 210, 30, 120, 220, 40, 130, 230));
    assertArrayEquals(
        bytes(10, 105, 20, 205, 30, 125, 40, 225),
        converted(image, UImageFormat.IMAGE_YUV422).getData());
    assertArrayEquals(
        bytes(10, 20, 30, 40, 115, 215), converted(image, UImageFormat.IMAGE_NV12).getData());
    assertArrayEquals(
        bytes(10, 20, 30, 40, 115, 215),
        converted(image, UImageFormat.IMAGE_YUV420_PLANAR).getData());
    assertArrayEquals(
        bytes(10, 20, 30, 40, 105, 125, 205, 225),
        converted(image, UImageFormat.IMAGE_YUV411_PLANAR).getData());
    assertArrayEquals(bytes(10, 20, 30, 40), converted(image, UImageFormat.IMAGE_GREY8).getData());
    assertArrayEquals(bytes(0x11, 0x22), converted(image, UImageFormat.IMAGE_GREY4).getData());
    UImage ppm = converted(gradient(1, 1), UImageFormat.IMAGE_PPM);
    assertEquals("P6\n1 1\n255\n<<x", new String(ppm.getData(), StandardCharsets.ISO_8859_1));
  }

  @Test
  void sizesAreConvertedToo() {
    UImage result = new UImage();
    result.setImageFormat(UImageFormat.IMAGE_GREY8);
    result.setWidth(3);
    UConversion.convert(
        new UImage(UImageFormat.IMAGE_GREY8, 6, 1, bytes(0, 20, 40, 60, 80, 100)), result);
    assertEquals(1, result.getHeight());
    assertArrayEquals(bytes(10, 50, 90), result.getData());
  }

  @Test
  void jpegFilesTellTheirSize() {
    byte[] jpeg = UConversion.convertRGBtoJPEG(gradient(40, 30).getData(), 40, 30, 90);
    assertArrayEquals(bytes(0xff, 0xd8), Arrays.copyOf(jpeg, 2));
    UImage image = UConversion.convertJPEGtoRGB(jpeg);
    assertEquals(40, image.getWidth());
    assertEquals(30, image.getHeight());
    assertTrue(
        UConversion.convertRGBtoJPEG(gradient(40, 30).getData(), 40, 30, 10).length < jpeg.length);
  }

  @Test
  void brokenImagesAreRefused() {
    UImage small = new UImage(UImageFormat.IMAGE_RGB, 10, 10, new byte[299]);
    assertEquals(
        "an image of 10 x 10 pixels in rgb has 299 bytes instead of 300",
        refused(small).getMessage());
    for (UImageFormat format : UImageFormat.values()) {
      refused(new UImage(format, 10, 10, new byte[10]));
      refused(new UImage(format, 0, 10, new byte[10]));
      refused(new UImage(format, 1 << 20, 1 << 20, new byte[10]));
    }
    assertThrows(
        UConversionException.class, () -> converted(gradient(2, 2), UImageFormat.IMAGE_UNKNOWN));
    assertThrows(
        UConversionException.class, () -> UConversion.convertRGBtoJPEG(new byte[12], 2, 2, 101));
  }

  private static UConversionException refused(UImage image) {
    return assertThrows(
        UConversionException.class, () -> converted(image, UImageFormat.IMAGE_YCbCr));
  }

  /** What {@link #withoutDesktop} runs. */
  static final class WithoutDesktop {
    public static void main(String[] arguments) {
      UImage grey = converted(gradient(4, 4), UImageFormat.IMAGE_GREY8);
      try {
        converted(grey, UImageFormat.IMAGE_JPEG);
      } catch (UConversionException e) {
        System.out.print(e.getMessage());
      }
    }
  }

  @Test
  void withoutDesktop() throws Exception {
    Process java =
        new ProcessBuilder(
                System.getProperty("java.home") + "/bin/java",
                "--limit-modules",
                "java.base",
                "-cp",
                System.getProperty("java.class.path"),
                WithoutDesktop.class.getName())
            .redirectErrorStream(true)
            .start();
    String said = new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals("JPEG images need the module java.desktop, which this Java does not have", said);
  }

  private static USound raw(
      int channels, int rate, int size, USoundSampleFormat format, byte[] data) {
    return new USound(USoundFormat.SOUND_RAW, channels, rate, size, format, data);
  }

  private static USound like(
      USoundFormat format, int channels, int rate, int size, USoundSampleFormat sampleFormat) {
    return new USound(format, channels, rate, size, sampleFormat, new byte[0]);
  }

  @Test
  void sizesAndSignsOfSamples() {
    USound source =
        raw(1, 8000, 8, USoundSampleFormat.SAMPLE_UNSIGNED, bytes(0, 64, 128, 192, 255));
    USound wide = like(USoundFormat.SOUND_RAW, 0, 0, 16, USoundSampleFormat.SAMPLE_SIGNED);
    UConversion.convert(source, wide);
    assertEquals("raw 1 8000 16 1", wide.headers());
    assertArrayEquals(bytes(0, 0x80, 0, 0xc0, 0, 0, 0, 0x40, 0, 0x7f), wide.getData());
    USound back = like(USoundFormat.SOUND_RAW, 0, 0, 8, USoundSampleFormat.SAMPLE_UNSIGNED);
    UConversion.convert(wide, back);
    assertEquals(source, back);
    USound floats = like(USoundFormat.SOUND_RAW, 0, 0, 32, USoundSampleFormat.SAMPLE_FLOAT);
    UConversion.convert(wide, floats);
    assertArrayEquals(bytes(0, 0, 0x80, 0xbf), Arrays.copyOf(floats.getData(), 4));
    USound again = like(USoundFormat.SOUND_RAW, 0, 0, 16, USoundSampleFormat.SAMPLE_SIGNED);
    UConversion.convert(floats, again);
    assertEquals(wide, again);
  }

  @Test
  void numbersOfChannels() {
    USound stereo =
        raw(2, 8000, 8, USoundSampleFormat.SAMPLE_SIGNED, bytes(10, 20, -30, -10, 100, 0));
    USound mono = like(USoundFormat.SOUND_RAW, 1, 0, 0, null);
    UConversion.convert(stereo, mono);
    assertArrayEquals(bytes(15, -20, 50), mono.getData());
    USound both = like(USoundFormat.SOUND_RAW, 2, 0, 0, null);
    UConversion.convert(mono, both);
    assertArrayEquals(bytes(15, 15, -20, -20, 50, 50), both.getData());
  }

  @Test
  void rates() {
    USound source = raw(1, 8000, 8, USoundSampleFormat.SAMPLE_SIGNED, bytes(0, 20, 40, 60));
    USound faster = like(USoundFormat.SOUND_RAW, 0, 16000, 0, null);
    UConversion.convert(source, faster);
    assertArrayEquals(bytes(0, 10, 20, 30, 40, 50, 60, 60), faster.getData());
    USound slower = like(USoundFormat.SOUND_RAW, 0, 8000, 0, null);
    UConversion.convert(faster, slower);
    assertArrayEquals(source.getData(), slower.getData());
  }

  @Test
  void wavFiles() {
    USound source =
        raw(2, 44100, 16, USoundSampleFormat.SAMPLE_SIGNED, bytes(1, 2, 3, 4, 5, 6, 7, 8));
    USound wav = like(USoundFormat.SOUND_WAV, 0, 0, 0, null);
    UConversion.convert(source, wav);
    assertEquals(52, wav.getSize());
    assertEquals("RIFF", new String(wav.getData(), 0, 4, StandardCharsets.US_ASCII));
    assertArrayEquals(bytes(44, 0, 0, 0), Arrays.copyOfRange(wav.getData(), 4, 8));
    assertArrayEquals(bytes(0x44, 0xac, 0, 0), Arrays.copyOfRange(wav.getData(), 24, 28));
    USound back = like(USoundFormat.SOUND_RAW, 0, 0, 0, null);
    UConversion.convert(wav, back);
    assertEquals(source, back);
    USound bytes = like(USoundFormat.SOUND_WAV, 1, 22050, 8, USoundSampleFormat.SAMPLE_SIGNED);
    UConversion.convert(wav, bytes);
    assertEquals(USoundSampleFormat.SAMPLE_UNSIGNED, bytes.getSampleFormat());
    assertEquals(45, bytes.getSize());
  }

  @Test
  void brokenSoundsAreRefused() {
    USound raw = like(USoundFormat.SOUND_RAW, 0, 0, 0, null);
    for (int length = 0; length < 44; length++) {
      USound wav = like(USoundFormat.SOUND_WAV, 0, 0, 0, null);
      UConversion.convert(raw(1, 8000, 8, USoundSampleFormat.SAMPLE_UNSIGNED, new byte[10]), wav);
      wav.setData(Arrays.copyOf(wav.getData(), length));
      assertThrows(UConversionException.class, () -> UConversion.convert(wav, raw));
    }
    assertThrows(
        UConversionException.class,
        () -> UConversion.convert(like(USoundFormat.SOUND_MP3, 1, 1, 8, null), raw));
    assertThrows(
        UConversionException.class,
        () -> UConversion.convert(like(USoundFormat.SOUND_RAW, 1, 8000, 12, null), raw));
    assertThrows(
        UConversionException.class,
        () -> UConversion.convert(like(USoundFormat.SOUND_RAW, 0, 0, 0, null), raw));
  }
}
