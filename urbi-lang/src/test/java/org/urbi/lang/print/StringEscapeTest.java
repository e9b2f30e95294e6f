package org.urbi.lang.print;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import org.junit.jupiter.api.Test;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.UrbiParser;

class StringEscapeTest {
  @Test
  void quotes() {
    assertEquals("\"\"", StringEscape.quote(""));
    assertEquals("\"a'b\\\"c\\\\d\"", StringEscape.quote("a'b\"c\\d"));
    assertEquals(
        "\"\\a\\b\\f\\n\\r\\t\\v\\x00\\x7f\\xff\"",
        StringEscape.quote("\007\b\f\n\r\t\013\0\u007f\u00ff"));
  }

  @Test
  void quotesNames() {
    assertEquals("foo_1", StringEscape.name("foo_1"));
    assertEquals("new", StringEscape.name("new"));
    assertEquals("'if'", StringEscape.name("if"));
    assertEquals("'int'", StringEscape.name("int"));
    assertEquals("'1a'", StringEscape.name("1a"));
    assertEquals("''", StringEscape.name(""));
    assertEquals("'a\\'\"'", StringEscape.name("a'\""));
    assertEquals("'wchar_t'", StringEscape.name("wchar_t"));
    assertEquals("'self'", StringEscape.name("self"));
    assertEquals("If", StringEscape.name("If"));
  }

  @Test
  void appends() {
    var text = new StringBuilder("x");
    StringEscape.appendName(text, "a");
    StringEscape.appendName(text, "a\n");
    StringEscape.appendQuoted(text, "b\tcd\"");
    StringEscape.append(text, "ab'cd", 1, 4, '\'');
    assertEquals("xa'a\\n'\"b\\tcd\\\"\"b\\'c", text.toString());
  }

  @Test
  void readsBackEveryByte() {
    var all = new StringBuilder();
    for (char c = 0; c < 256; c++) {
      all.append(c).append('7');
    }
    var tree = UrbiParser.parse(StringEscape.quote(all.toString()), null).sequence();
    var string = assertInstanceOf(Ast.StringLiteral.class, tree.statements().get(0));
    assertEquals(all.toString(), string.value());
  }
}
