package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compiled loops count their cycles themselves, and tell everybody who asks. */
class CountedLoopTest {
  private static final String FUNCTIONS =
      """
      function plain(n) { var i = 0; while (i < n) { i += 1 }; i }|;
      function body(n) { var i = 0; while| (i < n) { i += 1; i += 1; i }; i }|;
      function leaves(n) {
        var i = 0;
        while (true) { i++; if (i > n) break; if (i == 150) return i }; -i
      }|;
      function each(n) {
        var s = 0;
        for (var i : n) { s += i; if (i == 3) continue; s += 1 }; s
      }|;
      function asks(n) {
        var i = 0; var c = System.cycle;
        while (i < n) { i += 1; if (i == n - 3) echo(System.cycle - c); i += 1 };
        System.cycle - c
      }|;
      function inner(n) {
        var s = 0;
        for (var i : n) { var j = 0; while (j < 7) { s += j; j++ } }; s
      }|;
      function fails(n) { var i = 0; while (true) { i += 1; if (i > n) i = i + nil } }|;
      function tries(n) {
        var i = 0;
        while (i < n) { i++; try { if (i % 7 == 0) throw i; i += 1 } catch (var e) { i += e } };
        try { fails(n) } catch (var e) { echo(e.message) }
      }|;
      class Box { var n = 0; function up { n += 1 } }|;
      var box = Box.new|;
      function slots(b, k) { while (b.n < k) { b.n += 1; b.n }; while (b.n > 0) { b.n -= 2; b.up } }|;
      function grows(n) { var l = [0]; var i = 0; while (i < n) { l[0] += i; l << i; i++ }; l.size }|;
      function maps(n) {
        var d = [=>]; var i = 0;
        while (i < n) { d[i % 5] = i; d["x"] = i; d[i % 5] += 1; i++ }; d.size * 1000 + d[1]
      }|;
      function texts(n) {
        var t = "a"; var i = 0; var s = 0;
        while (i < n) { if (t == "a") { s += 1; t = "b" } else t = "a"; if (t != nil) s += 1; i++ }; s
      }|;
      function chooses(n) {
        var i = 0; var s = 0;
        while (i < n) {
          switch (i % 4) {
            case 0: s += 1; var a = s; s += a; s %= 1000;
            case 1: { var b = i; s -= b; s };
            case 2: if (i % 3 == 0) { i += 1; continue } else { s += 2; s }
          };
          try { s += 1; if (i % 9 == 0) throw "nine"; s += 1 } catch (var e) { s += 3; s }
          finally { s += 4; s };
          i += 1
        };
        s
      }|;
      """;

  private static final String PROGRAM =
      FUNCTIONS
          + """
          function used(name, n) {
            var c = System.cycle;
            switch (name) {
              case "plain": echo(plain(n)); case "body": echo(body(n)); case "leaves": echo(leaves(n));
              case "each": echo(each(n)); case "asks": echo(asks(n)); case "inner": echo(inner(n));
              case "tries": tries(n); case "slots": slots(box, n); case "grows": echo(grows(n));
              case "chooses": echo(chooses(n)); case "maps": echo(maps(n)); case "texts": echo(texts(n))
            };
            echo(name + ": " + (System.cycle - c))
          }|;
          function all(n) {
            for (var name : ["plain", "body", "leaves", "each", "asks", "inner", "tries", "slots", "grows",
                             "chooses", "maps", "texts"])
              used(name, n)
          }|;
          all(9); all(130); all(250);
          { var c = System.cycle; plain(77), body(30) & leaves(20); each(9); echo(System.cycle - c) };
          { var c = System.cycle; var i = 0; while (i < 40) { i += 1; i.none }; };
          var t = Tag.new|; var seen = 0|;
          t: while (true) { seen += 1; seen == 0 },
          sleep(1ms)|; t.stop; var after = seen|; sleep(1ms)|; after == seen; after; System.cycle;
          function starts(n) {
            var i = 0;
            while (i < n) { i += 1; lobby.seen = i; if (i == 60) detach({ echo(lobby.seen) }) }
          }|;
          starts(90); starts(90); sleep(1ms); System.cycle;
          function exposed(n) {
            var i = 0;
            { sleep(1ms); i = -n } & while (i >= 0) { i += 1 };
            i
          }|;
          exposed(5); exposed(6); System.cycle;
          var plus = Float.getSlotValue("+")|;
          function redefines(n) {
            var i = 0; var s = 0;
            while (i < n) {
              i = i + 1; s = s - i;
              if (i == 20) Float.'+' = function(x) { echo(System.cycle - lobby.start) | 21 };
              if (i == 21) Float.'+' = lobby.getSlotValue("plus")
            };
            s
          }|;
          var told = [0]|; at (told[0] == 30) echo("told " + System.cycle);
          at (told.size == 70) echo("grown " + System.cycle);
          function tells(n) {
            var l = lobby.told; var i = 0;
            while (i < n) { l[0] = i; i++; l << i; if (i == 20) { var k = [0]; k[0] = l.size; l << k[0] }; i }
          }|;
          tells(80); System.cycle;
          var noted = ["x" => 0]|; at (noted["x"] == 30) echo("noted " + System.cycle);
          function notes(n) {
            var d = lobby.noted; var i = 0;
            while (i < n) { d["x"] = i; i++; d[i] = i; i }
          }|;
          notes(60); System.cycle;
          function maybe(i) { if (i != 50) "a" }|;
          function compares(n) {
            var i = 0; var s = 0;
            while (i < n) { i++; if (nil != i) s += 1; if ("a" == maybe(i)) s += 2 }; s
          }|;
          compares(40); compares(60); System.cycle;
          var start = System.cycle|; redefines(40); Float.setSlot("+", getSlotValue("plus"))|; System.cycle - start;
          """;

  @ParameterizedTest
  @CsvSource({"1, 0", "2, 0", "5, 0", "1, 3", "3, 2"})
  void theCyclesAreThoseOfTheInterpreter(int threshold, int doubt) {
    CompiledCodeTest.compare(threshold, doubt, PROGRAM);
  }

  /** Where many more than a hundred are lent at once. */
  @Test
  void longLoopsHaveTheSameCyclesInRealTime() {
    String program =
        FUNCTIONS
            + """
            function cycles(f) { var c = System.cycle; f(40000); System.cycle - c }|;
            function twice(n) { plain(n); plain(17); 1; 2; 3; each(n) }|;
            for (2) { for (var f : [&plain, &body, &each, &inner, &grows, &twice]) echo(cycles(&f)) };
            """;
    String interpreted = KernelSession.runCompiledInRealTime(0, program);
    assertFalse(interpreted.contains("!!!"), interpreted);
    assertEquals(interpreted, KernelSession.runCompiledInRealTime(2, program));
  }

  /** Whether there is anything to compare: a loop that calls somebody asks at each cycle. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          plain(9) | true
          body(9) | true
          leaves(9) | true
          each(9) | true
          asks(9) | false
          inner(9) | true
          tries(9) | true
          slots(box, 9) | true
          grows(9) | true
          chooses(9) | true
          maps(9) | true
          texts(9) | true
          """)
  void theseLoopsCount(String call, boolean counting) {
    String calls = (call + "|; ").repeat(3);
    String output =
        KernelSession.runCompiled(2, 0, 0, FUNCTIONS + calls + "System.tier[\"counting\"] > 0;");
    assertTrue(output.endsWith("] " + counting + "\n"), output);
  }

  /** Twice it would have more bytes than the Java machine compiles. */
  @Test
  void aLongLoopIsCompiledOnce() {
    String program =
        """
        var before = System.tier["refused"]|;
        function big(n) { var i = 0; var s = 0; while (i < n) { %s i += 1 }; s }|;
        big(9); big(150); System.tier["refused"] - before;
        """
            .formatted("s += i; ".repeat(25));
    String compiled = KernelSession.runCompiled(1, 0, 0, program);
    assertTrue(compiled.contains("] 900\n"), compiled);
    assertTrue(compiled.contains("] 279375\n"), compiled);
    assertTrue(compiled.endsWith("] 0\n"), compiled);
  }
}
