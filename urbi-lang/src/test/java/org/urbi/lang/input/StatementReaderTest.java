package org.urbi.lang.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.urbi.lang.print.Printer;

class StatementReaderTest {
  /** Everything that must not be mistaken for the end of a statement, and everything that is. */
  private static final String SESSION =
      """
      1; a, b | c & d; // comment ; with "quotes'
      /* ; /* nested " */ ; */ "x;\\"y\\\\"; 'quoted ; \\' name' = 2,
      "\\B(4)(";)')"; "\\B(x)"; "\\B(1)(ab"; f(1, [2; 3]); { a; b, c };
      loop; { break }; loop, a; every, (1s) b; for ; (3) c; while, (x) y;
      class A : B, C {}; class A : B, C { x, }, class D;
      var a = BIN 5 jpeg;;"({[/ x;
      BIN 0;; BIN + 1; BIN 1x; x'in; x''; x'; function'+'(a) {};
      if (a) b; else c; echo(1)); ) ; ( ] ; [ ( ) ; { ( } ; 123foo; #;
      1 / 2; a //
      ; 1./**/foo;; ,
      //#push 100 "foo"
      x y z;
        //#line 3 "ignored"
      //#pop
      $;
      \tlast
      """;

  private static List<String> drain(StatementReader reader) {
    var items = new ArrayList<String>();
    for (Item item = reader.next(); item != null; item = reader.next()) {
      items.add(show(item));
    }
    return items;
  }

  private static String show(Item item) {
    return switch (item) {
      case Item.Statement s ->
          s.tree().span().location() + " " + Printer.print(s.tree()) + s.separator().text();
      case Item.Invalid i ->
          i.errors().toString().replaceAll("source=[^,]*", "")
              + i.errors().get(0).span().location();
    };
  }

  private static List<String> read(String... chunks) {
    var reader = new StatementReader("f.u");
    var items = new ArrayList<String>();
    for (String chunk : chunks) {
      reader.feed(chunk);
      items.addAll(drain(reader));
    }
    reader.end();
    items.addAll(drain(reader));
    Item unfinished = reader.unfinished();
    items.add(unfinished == null ? "nothing" : show(unfinished));
    return items;
  }

  @Test
  void splitsAnywhere() {
    List<String> whole = read(SESSION);
    assertEquals(whole, read(SESSION.split("")));
    for (int i = 1; i < SESSION.length(); i++) {
      assertEquals(whole, read(SESSION.substring(0, i), SESSION.substring(i)), "at " + i);
    }
  }

  @Test
  void findsTheEnds() {
    List<String> items = read("1; a, b | c & d;{ a; b, c };loop; { break };class A : B, C {};x;");
    assertEquals(
        List.of(
            "f.u:1.1 1;",
            "f.u:1.4 a,",
            "f.u:1.7-15 b | c & d;",
            "f.u:1.17-27 {\n  a;\n  b,\n  c\n};",
            "f.u:1.29-43 loop\n{ break };",
            "f.u:1.45-61 class A: B, C\n{};",
            "f.u:1.63 x;",
            "nothing"),
        items);
  }

  @Test
  void goesOnAfterErrors() {
    assertEquals(
        List.of("f.u:1.1-2", "2.1 echo(1);", "f.u:2.17", "f.u:3.1-4", "4.1 3;", "nothing"),
        read("4x;\necho(1); echo(2));\nelse c;\n3;").stream()
            .map(s -> s.replaceAll("^\\[.*\\]", "").replaceAll("^f.u:(\\d+\\.\\d+)\\S* ", "$1 "))
            .toList());
  }

  @Test
  void knowsWhenItWaits() {
    var reader = new StatementReader(null);
    assertFalse(reader.pending());
    reader.feed("  // comment\n ");
    assertNull(reader.next());
    assertFalse(reader.pending());
    reader.feed("1 +");
    assertNull(reader.next());
    assertTrue(reader.pending());
    reader.feed(" 2; ");
    assertNotNull(reader.next());
    assertNull(reader.next());
    assertFalse(reader.pending());
    reader.feed("/*");
    assertNull(reader.next());
    assertTrue(reader.pending());
  }

  @Test
  void tellsOfAnUnfinishedStatement() {
    var reader = new StatementReader("f.u");
    reader.feed("1; 2 | 3 \n// no separator\n");
    reader.end();
    assertNotNull(reader.next());
    assertNull(reader.next());
    var error = assertInstanceOf(Item.Invalid.class, reader.unfinished()).errors().getFirst();
    assertEquals("syntax error: unexpected end of file", error.message());
    assertEquals("f.u:1.9", error.span().location().toString());
    assertNull(reader.unfinished());
  }

  @Test
  void countsLines() {
    var reader = new StatementReader("f.u");
    reader.feed("1;\n2; 3\n;\n//#push 100 \"foo\"\n4;\n\n//#pop\n5; \"\n\n\"; 6;");
    assertEquals(
        List.of("f.u:1.1", "f.u:2.1", "f.u:2.4", "foo:100.1", "f.u:5.1", "f.u:5.4-7.1", "f.u:7.4"),
        drain(reader).stream().map(s -> s.substring(0, s.indexOf(' '))).toList());
  }

  @Test
  void boundsStatements() {
    var reader = new StatementReader("f.u", () -> 100, () -> {});
    reader.feed("1; ");
    reader.feed("x".repeat(90));
    assertNotNull(reader.next());
    assertNull(reader.next());
    reader.feed("x".repeat(90));
    Item.Invalid refused = assertInstanceOf(Item.Invalid.class, reader.next());
    assertEquals(
        "syntax error: statement longer than 100 characters", refused.errors().get(0).message());
    for (int i = 0; i < 1000; i++) {
      reader.feed("y \"".repeat(100));
      assertNull(reader.next());
    }
    assertTrue(reader.pending());
    reader.feed(";\n2;");
    assertEquals("f.u:2.1 2;", show(reader.next()));
  }

  @Test
  void isLinear() {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadCpuTime();
    var reader = new StatementReader(null);
    reader.feed("var s = \"");
    for (int i = 0; i < 5_000; i++) {
      reader.feed("x".repeat(1000));
      assertNull(reader.next());
    }
    for (int i = 0; i < 300_000; i++) {
      reader.feed("z");
      assertNull(reader.next());
    }
    reader.feed("\";" + "1;".repeat(20_000));
    int count = 0;
    for (Item item = reader.next(); item != null; item = reader.next()) {
      assertInstanceOf(Item.Statement.class, item);
      reader.feed(" ");
      count++;
    }
    assertEquals(20_001, count);
    long seconds = TimeUnit.NANOSECONDS.toSeconds(threads.getCurrentThreadCpuTime() - before);
    assertTrue(seconds < 20, "so many seconds of the processor: " + seconds);
  }
}
