package urbi;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class UValueTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "42 | 42",
        "-2.5 | -2.5",
        "- 3 | -3",
        "1e3 | 1000",
        "1.5e-7 | 1.5e-7",
        "1e300 | 1e300",
        "0x_ff | 255",
        "1_000 | 1000",
        "200ms | 0.2",
        "1min30s | 90",
        "180deg | 3.141592653589793",
        "inf | inf",
        "-inf | -inf",
        "nan | nan",
        "true | 1",
        "false | 0",
        "void | void",
        "nil | void",
        "[] | []",
        "[ 1,2 , [\"a\"],] | [1, 2, [\"a\"]]",
        "(1, 2) | [1, 2]",
        "(1,) | [1]",
        "[=>] | [ => ]",
        "[ => ] | [ => ]",
        "[\"b\" => 1, \"a\"=>[2]] | [\"b\" => 1, \"a\" => [2]]",
        "\"a\\\"b\\\\\\n\\x41\\101\" | \"a\\\"b\\\\\\nAA\"",
        "\"ab\" \"cd\" | \"abcd\"",
        "\"\\B(3)(\\\"x)\" | \"\\\\\\\"x\"",
        "BIN 3 jpeg 1 1;a;b | BIN 3 jpeg 1 1;a;b",
        "BIN 2;ab | BIN 2;ab",
        "[BIN 2;],, 4] | [BIN 2;],, 4]",
        "camera.val | camera.val",
        "Object_0x1f | Object_0x1f",
      })
  void literals(String read, String shown) {
    UValue value = UValue.parse(read);
    assertEquals(shown, value.toString());
    assertEquals(value, UValue.parse(value.toString()));
    assertEquals(value, UValue.parse(read.getBytes(StandardCharsets.UTF_8)));
    assertEquals(value, UValue.parse(value.toBytes()));
    assertEquals(value.hashCode(), UValue.parse(value.toBytes()).hashCode());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "[",
        "[1",
        "[1 2]",
        "\"",
        "\"\\q\"",
        "\"\\x4\"",
        "\"\\400\"",
        "1 2",
        "1x",
        "12__s",
        "]",
        "BIN",
        "BIN 5;abc",
        "BIN 99999999999;a",
        "[\"a\" => 1, 2]",
        "-",
        "1.2.3",
        "\"\\B(9)(a)\"",
        "1e",
        "0x"
      })
  void invalidLiteralIsRefused(String text) {
    assertThrows(UParseException.class, () -> UValue.parse(text));
  }

  @Test
  void nestingHasALimit() {
    assertThrows(UParseException.class, () -> UValue.parse("[".repeat(1_000_000)));
  }

  @Test
  void textIsUtf8OnTheWire() {
    UValue value = new UValue("é€😀\u0001");
    assertEquals("\"é€😀\\x01\"", value.toString());
    assertArrayEquals("\"é€😀\\x01\"".getBytes(StandardCharsets.UTF_8), value.toBytes());
    assertEquals(value, UValue.parse(value.toBytes()));
    assertEquals(value, UValue.parse(value.toString()));
    assertEquals("é", UValue.parse("\"\\xc3\\xa9\"").stringValue());
    assertEquals("\u00ff", UValue.parse("\"\\xff\"").stringValue());
    assertEquals("\u00e9", UValue.parse(new byte[] {'"', (byte) 0xe9, '"'}).stringValue());
  }

  @Test
  void dataOfBinariesAreAnyBytes() {
    byte[] data = new byte[256];
    for (int i = 0; i < data.length; i++) {
      data[i] = (byte) i;
    }
    UValue value = new UValue(UList.of("é", new UBinary("all bytes", data), 1));
    assertEquals(value, UValue.parse(value.toBytes()));
    assertEquals(value, UValue.parse(value.toString()));
  }

  @Test
  void numbersAreNotRounded() {
    Random random = new Random(42);
    for (int i = 0; i < 10_000; i++) {
      double number = Double.longBitsToDouble(random.nextLong());
      assertEquals(new UValue(number), UValue.parse(new UValue(number).toBytes()));
    }
  }

  @Test
  void gettersConvertWithoutLoss() {
    assertEquals(42, new UValue("42").intValue());
    assertEquals(-2147483648, new UValue(2147483648.0).intValue());
    assertEquals(0.2, new UValue("200ms").doubleValue());
    assertEquals("42", new UValue(42).stringValue());
    assertEquals("42.5", new UValue(42.5).stringValue());
    assertTrue(new UValue(2).booleanValue());
    assertEquals(1, new UValue(true).intValue());
    assertEquals("c", new UValue('c').stringValue());
    assertEquals("x.y", UValue.slotName("x.y").stringValue());
    assertEquals(
        "invalid cast to double from \"many\"",
        assertThrows(UCastException.class, () -> new UValue("many").doubleValue()).getMessage());
    assertEquals(
        "invalid cast to String from [1]",
        assertThrows(UCastException.class, () -> new UValue(UList.of(1)).stringValue())
            .getMessage());
    assertEquals(
        "invalid cast to UImage from BIN 1 raw 1 2 3 1",
        assertThrows(
                UCastException.class,
                () -> new UValue(new UBinary("raw 1 2 3 1", new byte[1])).uimageValue())
            .getMessage());
    assertThrows(UCastException.class, () -> new UValue().doubleValue());
    assertThrows(UCastException.class, () -> new UValue(1).ulistValue());
    assertThrows(UCastException.class, () -> new UValue(1).udictionaryValue());
    assertThrows(UCastException.class, () -> new UValue(1).ubinaryValue());
  }

  @Test
  void imagesAndSoundsAreBinaries() {
    UImage image = new UImage(UImageFormat.IMAGE_JPEG, 320, 240, new byte[] {1, 2});
    UValue value = new UValue(image);
    assertEquals("jpeg 320 240", value.ubinaryValue().getMessage());
    assertEquals(UBinaryType.BINARY_IMAGE, value.ubinaryValue().getType());
    assertEquals(image, value.uimageValue());
    assertSame(image.getData(), value.uimageValue().getData());
    USound sound =
        new USound(
            USoundFormat.SOUND_RAW, 2, 44100, 16, USoundSampleFormat.SAMPLE_SIGNED, new byte[4]);
    UValue heard = new UValue(sound);
    assertEquals("raw 2 44100 16 1", heard.ubinaryValue().getMessage());
    assertEquals(UBinaryType.BINARY_SOUND, heard.ubinaryValue().getType());
    assertEquals(sound, heard.usoundValue());
    assertEquals(UBinaryType.BINARY_NONE, new UBinary().getType());
    assertEquals(UBinaryType.BINARY_UNKNOWN, new UBinary("mine", new byte[1]).getType());
    assertThrows(IllegalArgumentException.class, () -> new UBinary("a;b", new byte[1]));
  }

  record Point(double x, double y) {}

  record Path(String name, List<Point> points, Point[] ends, Map<String, Integer> counts) {
    @Override
    public boolean equals(Object other) {
      return other instanceof Path that
          && name.equals(that.name)
          && points.equals(that.points)
          && List.of(ends).equals(List.of(that.ends))
          && counts.equals(that.counts);
    }

    @Override
    public int hashCode() {
      return name.hashCode();
    }
  }

  static class Pose {
    private double x;
    private String frame = "world";
  }

  enum Mode {
    SLOW,
    FAST
  }

  @Test
  void structuresAreDictionaries() {
    assertEquals("[\"$sn\" => \"Point\", \"x\" => 1, \"y\" => 2]", UValue.of(new Point(1, 2)) + "");
    Point a = new Point(1, 2);
    Point b = new Point(3, 4);
    Path path = new Path("way", List.of(a, b), new Point[] {a, b}, Map.of("n", 2));
    assertEquals(path, UValue.parse(UValue.of(path).toBytes()).as(Path.class));
    assertThrows(UCastException.class, () -> new UValue(1).as(Point.class));
    assertEquals(
        "a Point is missing field y: [\"x\" => 1]",
        assertThrows(
                UCastException.class,
                () -> new UValue(new UDictionary().with("x", 1)).as(Point.class))
            .getMessage());
  }

  @Test
  void classesAreStructuresOnceRegistered() {
    assertThrows(UCastException.class, () -> UValue.of(new Pose()));
    UCast.registerStruct(Pose.class, "x", "frame");
    Pose pose = new Pose();
    pose.x = 7;
    UValue value = UValue.of(pose);
    assertEquals("[\"$sn\" => \"Pose\", \"x\" => 7, \"frame\" => \"world\"]", value.toString());
    assertEquals(7, value.as(Pose.class).x);
    assertEquals("world", value.as(Pose.class).frame);
    assertThrows(IllegalArgumentException.class, () -> UCast.registerStruct(Pose.class, "missing"));
  }

  @Test
  void otherTypesAreRegisteredWithFunctions() {
    UCast.register(
        StringBuilder.class,
        text -> new UValue(text.reverse().toString()),
        value -> new StringBuilder(value.stringValue()));
    assertEquals("\"cba\"", UValue.of(new StringBuilder("abc")).toString());
    assertEquals("abc", new UValue("abc").as(StringBuilder.class).toString());
  }

  @Test
  void javaObjectsAndValues() {
    assertEquals("[1, \"a\", [2.5], [\"k\" => 1], void]", list().toString());
    assertEquals("FAST", UValue.of(Mode.FAST).stringValue());
    assertEquals(Mode.FAST, new UValue("FAST").as(Mode.class));
    assertThrows(UCastException.class, () -> new UValue("WARP").as(Mode.class));
    assertArrayEquals(new int[] {1, 2}, UValue.parse("[1, 2]").as(int[].class));
    assertArrayEquals(new byte[] {1, 2}, UValue.of(new byte[] {1, 2}).as(byte[].class));
    assertEquals(List.of(1.0, "a"), UValue.parse("[1, \"a\"]").as(Object.class));
    assertEquals(Map.of("a", 1.0), UValue.parse("[\"a\" => 1]").as(Map.class));
    assertEquals('c', new UValue("c").as(char.class));
    assertEquals((short) 3, new UValue(3).as(Short.class));
  }

  private static UValue list() {
    return new UValue(
        UList.of(1, "a", new double[] {2.5}, new UDictionary().with("k", true), null));
  }

  @Test
  void listsGrowAndShrink() {
    UList list = new UList().push_back(1).push_back("b");
    assertEquals(2, list.size());
    assertEquals(1, list.front().intValue());
    list.pop_back();
    assertEquals(UList.of(1), list);
    assertEquals(List.of(1), list.as(Integer.class));
    list.pop_back();
    assertThrows(java.util.NoSuchElementException.class, list::pop_back);
  }
}
