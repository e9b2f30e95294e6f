package org.urbi.lang.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.lang.print.Printer;

class StatementReaderTest {
  private static final String TEXT =
      """
      // A comment; with a separator.
      1; "a;\\B(3)(";")", { 2; 3 },
      /* ; /* ; */ ; */ while, (x) { y; };
      for (var i = 0; i < 3; i++) f(i, [1, 2]);
      );
      //#push 100 "foo"
      *;
      //#pop
      x'd; 'a;b';
        ;
      class A : B, C { x, y }, class D,
      bar
      """;

  private static List<String> read(String text, int step) {
    var reader = new StatementReader();
    List<String> items = new ArrayList<>();
    for (int i = 0; i < text.length(); i += step) {
      reader.feed(text.substring(i, Math.min(text.length(), i + step)));
      collect(reader, items);
    }
    reader.end();
    items.add(show(reader.rest()));
    return items;
  }

  private static void collect(StatementReader reader, List<String> items) {
    for (var item = reader.next(); item != null; item = reader.next()) {
      items.add(show(item));
    }
  }

  private static String show(StatementReader.Item item) {
    return switch (item) {
      case StatementReader.Item.Statement s ->
          s.ast().span().location() + " " + Printer.print(s.ast()) + " " + s.separator();
      case StatementReader.Item.Errors e ->
          e.errors().getFirst().span().location() + " " + e.errors().getFirst().message();
    };
  }

  @Test
  void reads() {
    assertEquals(
        List.of(
            "2.1 1 SEMICOLON",
            "2.4-17 \"a;\\\";\\\"\" COMMA",
            "2.20-27 {\n  2;\n  3\n} COMMA",
            "3.19-35 while, (x)\n{ y } SEMICOLON",
            "4.1-40 for (var i = 0; i.'<'(3); i++)\n{ f(i, [1, 2]) } SEMICOLON",
            "5.1 syntax error: unexpected )",
            "foo:100.1 syntax error: unexpected *",
            "7.1-3 x.'\\'d' SEMICOLON",
            "7.6-10 'a;b' SEMICOLON",
            "8.3  SEMICOLON",
            "9.1-23 class A: B, C\n{\n  x,\n  y\n} COMMA",
            "9.26-32 class D COMMA",
            "10.1-3 bar null"),
        read(TEXT, TEXT.length()));
  }

  @Test
  void readsByteByByte() {
    List<String> expected = read(TEXT, TEXT.length());
    for (int step = 1; step < 12; step++) {
      assertEquals(expected, read(TEXT, step));
    }
  }

  @Test
  void knowsWhetherSomethingIsPending() {
    var reader = new StatementReader();
    reader.feed("1; 2");
    assertNotNull(reader.next());
    assertNull(reader.next());
    assertEquals(true, reader.pending());
    reader.feed(";\n");
    assertNotNull(reader.next());
    assertNull(reader.next());
    assertFalse(reader.pending());
    assertNull(reader.rest());
  }
}
