package org.urbi.ros.codec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.InterfaceFiles;
import org.urbi.ros.message.ValueException;
import urbi.UDictionary;
import urbi.UValue;

/** What is longer than its type allows is neither sent nor taken from a peer. */
class BoundsTest {
  @TempDir private Path share;

  private Definitions definitions;

  @BeforeEach
  void define() throws Exception {
    Path folder = Files.createDirectories(share.resolve("bounds_msgs/msg"));
    for (String each : List.of("", "Free")) {
      // The second has the same bytes, and no limits.
      boolean limited = each.isEmpty();
      Files.writeString(folder.resolve(each + "Text.msg"), limited ? "string<=10 a" : "string a");
      Files.writeString(folder.resolve(each + "Wide.msg"), limited ? "wstring<=3 a" : "wstring a");
      Files.writeString(
          folder.resolve(each + "Numbers.msg"), limited ? "int32[<=3] a" : "int32[] a");
      Files.writeString(folder.resolve(each + "Bytes.msg"), limited ? "uint8[<=3] a" : "uint8[] a");
      Files.writeString(
          folder.resolve(each + "Texts.msg"), limited ? "string<=2[<=2] a" : "string[] a");
      Files.writeString(
          folder.resolve(each + "Outer.msg"), each + "Text[<=2] list\n" + each + "Texts one");
    }
    definitions = new Definitions(Dialect.ROS_2, new InterfaceFiles(List.of(share)));
  }

  private MessageCodec codec(String name) {
    return MessageCodec.of(definitions.message("bounds_msgs/" + name));
  }

  private static UDictionary message(String text) {
    return UValue.parse(text).udictionaryValue();
  }

  private String notSent(String type, String text) {
    return assertThrows(ValueException.class, () -> codec(type).encode(message(text))).getMessage();
  }

  private void passes(String type, String text) {
    assertEquals(message(text), codec(type).decode(codec(type).encode(message(text))));
  }

  private String notTaken(String type, String text) {
    byte[] bytes = codec("Free" + type).encode(message(text));
    return assertThrows(CodecException.class, () -> codec(type).decode(bytes)).getMessage();
  }

  @Test
  void theLongestPass() {
    passes("Text", "[\"a\" => \"0123456789\"]");
    passes("Text", "[\"a\" => \"ééééé\"]");
    passes("Wide", "[\"a\" => \"éé€\"]");
    passes("Numbers", "[\"a\" => [1, 2, 3]]");
    passes("Texts", "[\"a\" => [\"ab\", \"é\"]]");
    passes("Outer", "[\"list\" => [[\"a\" => \"0123456789\"]], \"one\" => [\"a\" => []]]");
  }

  @Test
  void whatIsTooLongIsNotSentAndTheFieldIsNamed() {
    assertEquals(
        "a: a string of 10 bytes at most expected, not of 11",
        notSent("Text", "[\"a\" => \"01234567890\"]"));
    assertEquals(
        "a: a string of 3 characters at most expected, not of 4",
        notSent("Wide", "[\"a\" => \"abcd\"]"));
    assertEquals(
        "a: 3 elements at most expected, not 4", notSent("Numbers", "[\"a\" => [1, 2, 3, 4]]"));
    assertEquals(
        "a: 3 elements at most expected, not 4", notSent("Bytes", "[\"a\" => [1, 2, 3, 4]]"));
    assertEquals(
        "a[1]: a string of 2 bytes at most expected, not of 3",
        notSent("Texts", "[\"a\" => [\"ab\", \"abc\"]]"));
    assertEquals(
        "list[0].a: a string of 10 bytes at most expected, not of 11",
        notSent("Outer", "[\"list\" => [[\"a\" => \"01234567890\"]], \"one\" => [\"a\" => []]]"));
    assertEquals(
        "one.a: 2 elements at most expected, not 3",
        notSent("Outer", "[\"list\" => [], \"one\" => [\"a\" => [\"\", \"\", \"\"]]]"));
  }

  /**
   * Ten characters, but eleven bytes: a peer that keeps its limit in bytes has no room for them.
   */
  @Test
  void bytesCountAndNotCharacters() {
    assertEquals(
        "a: a string of 10 bytes at most expected, not of 11",
        notSent("Text", "[\"a\" => \"é123456789\"]"));
  }

  @Test
  void whatAPeerSendsTooLongIsRefused() {
    assertEquals(
        "a string of 11 characters where 10 are allowed",
        notTaken("Text", "[\"a\" => \"01234567890\"]"));
    assertEquals(
        "a string of 4 characters where 3 are allowed", notTaken("Wide", "[\"a\" => \"abcd\"]"));
    assertEquals("4 elements where 3 are allowed", notTaken("Numbers", "[\"a\" => [1, 2, 3, 4]]"));
    assertEquals("4 elements where 3 are allowed", notTaken("Bytes", "[\"a\" => [1, 2, 3, 4]]"));
    assertEquals(
        "3 elements where 2 are allowed", notTaken("Texts", "[\"a\" => [\"\", \"\", \"\"]]"));
  }

  /** A node in Python sends that to those that have its own idea of the limit. */
  @Test
  void charactersOfMoreThanOneByteAreTakenFromAPeer() {
    String message = "[\"a\" => \"éééééééé😀😀\"]";
    byte[] bytes = codec("FreeText").encode(message(message));
    assertEquals(message(message), codec("Text").decode(bytes));
  }
}
