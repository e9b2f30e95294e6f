package org.urbi.kernel.builtin;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.kernel.ConsoleTranscript;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** What becomes of the arguments of a call, and which are refused. */
class ArgumentsTest {
  /** The answers to one statement, without the times and places of their lines. */
  private static String answer(String statement) {
    return ConsoleTranscript.run(statement + "\n")
        .lines()
        .map(line -> line.replaceFirst("^\\[[^]]*] (!!! \\d[^ ]* )?", ""))
        .collect(Collectors.joining("\n"));
  }

  /** Numbers of 32 bits, texts, truth, numbers, in functions of the library that take them. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"abc\" * 2;|\"abcabc\"",
        "\"abc\" * 0;|\"\"",
        "2 ** 3;|8",
        "String.fromAscii(65.9);|\"A\"",
        "5 bitand 4.9;|4",
        "5 bitand 4294967297;|1",
        "\"a\".isSpace;|false",
        "\"abc\".replace(\"b\", \"x\");|\"axc\"",
      })
  void whatFitsIsConverted(String statement, String answer) {
    assertEquals(answer, answer(statement));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"abc\" * \"x\";|*: argument 1: unexpected \"x\", expected a Float",
        "\"abc\".replace(\"b\", 1);|replace: argument 2: unexpected 1, expected a String",
        "\"abc\".replace(1, 2);|replace: argument 1: unexpected 1, expected a String",
        "2 ** void;|unexpected void",
        "2 ** nil;|**: argument 1: unexpected nil, expected a Float",
        "\"abc\" * -2;|*: argument 1: expected non-negative integer, got -2",
        "String.fromAscii(inf);|fromAscii: argument 1: expected integer, got inf",
        "String.fromAscii(nan);|fromAscii: argument 1: expected integer, got nan",
        "String.fromAscii(2147483648);|fromAscii: argument 1: expected integer, got 2147483648",
        "String.fromAscii(\"a\");|fromAscii: argument 1: unexpected \"a\", expected a Float",
        "5 bitand -inf;|bitand: argument 1: expected integer, got -inf",
        "5 bitand nan;|bitand: argument 1: expected integer, got nan",
      })
  void whatDoesNotFitIsRefusedWithItsPlace(String statement, String error) {
    String answer = answer(statement);
    assertTrue(answer.startsWith(error), answer);
  }

  @Test
  void theRestIsCopied() {
    UrbiObject[] all = new UrbiObject[3];
    World world = new World();
    Arrays.setAll(all, world.values()::number);
    assertArrayEquals(new UrbiObject[] {all[1], all[2]}, Arguments.rest(all, 1));
    assertNotSame(all, Arguments.rest(all, 0));
    assertEquals(0, Arguments.rest(all, 3).length);
    assertEquals(0, Arguments.rest(all, 4).length);
  }
}
