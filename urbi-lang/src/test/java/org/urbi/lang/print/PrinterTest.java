package org.urbi.lang.print;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.UrbiParser;
import org.urbi.lang.source.Source;

class PrinterTest {
  private static Ast parse(String text) {
    var source = new Source(text, 1, new Source.Line(0, null, 1));
    return UrbiParser.parse(source).program().statements().getFirst();
  }

  @ParameterizedTest
  @CsvSource({
    "1e-6, 1e-06", "1e11, 1e+11", "1000, 1000", "0.1, 0.1", "1234567, 1.23457e+06",
    "123456, 123456", "3.14159265, 3.14159", "-0.0, -0", "NaN, nan", "Infinity, inf",
    "999999.5, 1e+06", "1e-4, 0.0001", "1e100, 1e+100", "-2.5, -2.5"
  })
  void formatsFloats(double value, String text) {
    assertEquals(text, FloatFormat.format(value));
  }

  @Test
  void escapesStrings() {
    assertEquals("a\\n\\\"\\\\\\xff\\x00'", StringEscape.escape("a\n\"\\\u00ff\0'"));
  }

  @Test
  void printsBlocks() {
    assertEquals(
        "function () {\n  echo(\"a\");\n  if (x)\n  { y }\n  else\n  {};\n}",
        Printer.print(parse("function () { echo(\"a\"); if (x) y else {}; }")));
  }

  @Test
  void printsClaims() {
    assertEquals("1 == 1.'+'(1)", Printer.claim(parse("1 == 1 + 1")));
    assertEquals("1 in []", Printer.claim(parse("1 in []")));
  }
}
