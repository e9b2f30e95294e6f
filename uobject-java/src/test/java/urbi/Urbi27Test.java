package urbi;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.image.codec.jpeg.JPEGCodec;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import urbi.spi.ComponentFailureLog;

/** What programs for the SDK of Urbi 2.7 use besides what has tests of its own. */
class Urbi27Test {
  @Test
  void lists() {
    UList list = UList.of(1, "two", UList.of());
    assertEquals(new UValue("two"), list.get(1L));
    assertEquals(new UValue("two"), list.getArray().get(1));
    assertThrows(ArithmeticException.class, () -> list.get(1L << 32));
    assertEquals(List.of(new UValue(), new UValue()), new UValueVector(2));
  }

  @Test
  void typesOfValues() {
    assertEquals("double", new UValue(1).format_string());
    assertEquals("string", new UValue("x").format_string());
    assertEquals("list", UCast.toUValue(new UList()).format_string());
    assertEquals("dictionary", UCast.toUValue(new UDictionary()).format_string());
    assertEquals("binary", UCast.toUValue(new UBinary()).format_string());
    assertEquals("void", new UValue().format_string());
  }

  @Test
  void dictionaries() {
    UDictionary dictionary = new UDictionary();
    assertEquals(null, dictionary.put("number", 42));
    dictionary.put("list", new UList());
    dictionary.put("value", new UValue("x"));
    assertEquals(new UValue(42), dictionary.put("number", "other"));
    assertEquals("[\"number\" => \"other\", \"list\" => [], \"value\" => \"x\"]", "" + dictionary);
    assertThrows(UCastException.class, () -> dictionary.put("thread", Thread.currentThread()));
  }

  @Test
  void typesOfBinaries() {
    UBinary binary = new UBinary();
    assertEquals(UBinaryType.BINARY_NONE, binary.getType());
    binary.setType(UBinaryType.BINARY_IMAGE);
    assertEquals(UBinaryType.BINARY_IMAGE, binary.getType());
    binary.setMessage("raw 1 8000 8 1");
    assertEquals(UBinaryType.BINARY_SOUND, binary.getType(), "the header tells better");
    binary.clear();
    assertEquals(UBinaryType.BINARY_NONE, binary.getType());
  }

  @Test
  void deletedDataStayWithOthers() {
    UImage image = new UImage(UImageFormat.IMAGE_GREY8, 1, 2, new byte[] {1, 2});
    UImage copy = new UImage(image);
    assertSame(image.getData(), copy.getData());
    UValue value = new UValue(image);
    image.deleteData();
    assertEquals(0, image.getSize());
    assertArrayEquals(new byte[] {1, 2}, value.uimageValue().getData());
    assertArrayEquals(new byte[] {1, 2}, copy.getData());
    USound sound = new USound();
    sound.setData(new byte[] {1});
    sound.deleteData();
    assertEquals(0, sound.getSize());
    assertEquals(sound, new USound(sound));
  }

  @Test
  void vectorsAndMatrices() {
    UVector vector = new UVector(2);
    vector.set(1, -2.5);
    UValue packed = UCast.toUValue(vector);
    assertEquals("packed 8 d", packed.ubinaryValue().getMessage());
    assertEquals(vector, packed.as(UVector.class));
    assertEquals(vector, UCast.toUValue(List.of(0, -2.5)).as(UVector.class));
    assertEquals("<0, -2.5>", "" + vector);
    UMatrix matrix = new UMatrix(2, 3);
    matrix.set(1, 2, 7);
    assertEquals("packed 8 d 2 3", UCast.toUValue(matrix).ubinaryValue().getMessage());
    assertEquals(matrix, UCast.toUValue(matrix).as(UMatrix.class));
    assertEquals(matrix, UValue.parse("[[0, 0, 0], [0, 0, 7]]").as(UMatrix.class));
    assertEquals("<<0, 0, 0>, <0, 0, 7>>", "" + matrix);
    assertThrows(IndexOutOfBoundsException.class, () -> matrix.get(0, 3));
    for (String wrong :
        List.of("[[1], [2, 3]]", "7", "BIN 8 packed 8 d 2 3;12345678", "BIN 4 packed 8 d;1234")) {
      assertThrows(UCastException.class, () -> UValue.parse(wrong).as(UMatrix.class), wrong);
    }
    assertThrows(
        UCastException.class, () -> UValue.parse("BIN 8 packed 8 f;12345678").as(UVector.class));
  }

  @Test
  void median() {
    MedianFilter filter = new MedianFilter(3);
    filter.addElement(5);
    filter.addElement(-100);
    assertFalse(filter.checkSize());
    filter.addElement(4);
    assertTrue(filter.checkSize());
    assertEquals("[-100.0, 4.0, 5.0]", "" + filter);
    assertEquals(4, filter.getMedian());
    assertEquals("[]", "" + filter);
    assertThrows(IndexOutOfBoundsException.class, filter::getMedian);
    assertThrows(IllegalArgumentException.class, () -> new MedianFilter(0));
  }

  @Test
  void componentsOfPixels() {
    int pixel = 0xff2080e0;
    assertEquals(0x20, ImageFilter.getRed(pixel));
    assertEquals(0x80, ImageFilter.getGreen(pixel));
    assertEquals(0xe0, ImageFilter.getBlue(pixel));
    byte[] converted = UConversion.convertRGBtoYCbCr(new byte[] {0x20, (byte) 0x80, (byte) 0xe0});
    assertEquals(converted[0] & 0xff, ImageFilter.getY(pixel), 1);
    assertEquals(converted[1] & 0xff, ImageFilter.getCb(pixel), 1);
    assertEquals(converted[2] & 0xff, ImageFilter.getCr(pixel), 1);
  }

  @Test
  void oldSunJpegCodecReadsJpeg() throws IOException {
    byte[] file = UConversion.convertRGBtoJPEG(new byte[3 * 4 * 2], 4, 2, 90);
    BufferedImage image =
        JPEGCodec.createJPEGDecoder(new ByteArrayInputStream(file)).decodeAsBufferedImage();
    assertEquals(4, image.getWidth());
    assertEquals(2, image.getHeight());
    var nothing = JPEGCodec.createJPEGDecoder(new ByteArrayInputStream(new byte[] {1, 2}));
    assertThrows(IOException.class, nothing::decodeAsBufferedImage);
  }

  @Test
  void aFailureIsLoggedOnceForEachPlace() {
    List<String> log = new ArrayList<>();
    ComponentFailureLog failures = new ComponentFailureLog(log::add);
    for (int i = 0; i < 3; i++) {
      failures.log("Adder.add", new IllegalStateException("number " + i));
    }
    assertEquals(1, log.size());
    assertTrue(log.getFirst().startsWith("Adder.add: java.lang.IllegalStateException: number 0\n"));
    assertTrue(log.getFirst().contains("at urbi.Urbi27Test"), log::getFirst);
    failures.log("Adder.other", new IllegalStateException());
    assertEquals(2, log.size());
    Exception elsewhere = new Exception("thrown in C++");
    elsewhere.setStackTrace(new StackTraceElement[0]);
    failures.log("Adder.add", elsewhere);
    assertEquals(2, log.size());
  }
}
