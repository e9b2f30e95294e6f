package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compiled code calls functions that are slots of the target itself, as those of prototypes. */
class OwnFunctionsTest {
  private static final String PROGRAM =
      """
      function counter(start) {
        var o = Object.new; var n = start; var o.n = 0;
        var o.up = closure () { n += 1; n };
        var o.add = closure (x) { n += x; n };
        function o.me { n = this.n + 1; n };
        o
      }|;
      var a = counter(0)|; var b = counter(100)|;
      function ups(o, k) { var s = 0; for| (var i : k) { s += o.up + o.add(i) + o.me }; s }|;
      ups(a, 30); ups(b, 30); ups(a, 5); a.n; b.n;
      // Of the same shape, but what is there is something else.
      function reads(o) { o.up }|; function adds(o, x) { o.add(x) }|;
      function all(o) { try { echo(reads(o)) } catch (var e) { echo(e.message) };
                        try { echo(adds(o, 1)) } catch (var e) { echo(e.message) } }|;
      for (3) { all(a); all(b) };
      var c = counter(200)|; c.up = 7|; c.add = 8|; all(c); all(a);
      var d = counter(300)|; d.up = function () { this.n + 1000 }|;
      d.add = function (x) { this.n + x }|; all(d); all(b);
      var e = counter(400)|; e.up = function (x) { x }|; e.add = function () { 5 }|; all(e);
      var f = counter(500)|; f.up = Object.getSlotValue("new")|; f.add = "x".getSlotValue("size")|;
      f.up = f.getSlotValue("add")|; f.add = a.getSlotValue("add")|; all(f);
      var g = counter(600)|; g.add = function { call.evalArgs }|; all(g); all(a);
      a.add = function (x) { x * 2 }|; all(a); a.removeLocalSlot("add")|; all(a);
      // The arguments are evaluated once, whatever the function is.
      var count = 0|; function next { count += 1; count }|;
      function evaluates(o) { o.add(next) }|;
      for (4) evaluates(b); evaluates(c); evaluates(d); evaluates(g); count;
      // Functions that call themselves, for another target too.
      function tree(n) {
        var o = Object.new; var o.left = nil; var o.k = n;
        function o.sum { if (this.left == nil) this.k else this.k + this.left.sum };
        function o.down(x) { if (x < 1) this.k else down(x - 1) + 1 };
        if (n > 0) o.left = tree(n - 1);
        o
      }|;
      var t = tree(20)|; for (4) t.sum; t.sum; t.down(15); t.left.down(15);
      // A function that changes itself, and one that is changed while its arguments are evaluated.
      var h = Object.new|; function h.one { this.one = function () { 2 }; 1 }|;
      function ones { [h.one, h.one, h.one] }|; ones; ones;
      function h.two(x) { x }|;
      function twos(k) { h.two({ if (k == 5) h.two = function (x) { -x }; k }) }|;
      for (var k : 9) echo(twos(k));
      """;

  @ParameterizedTest
  @CsvSource({"1, 0", "2, 0", "5, 0", "1, 3", "3, 2"})
  void theyDoWhatTheInterpreterDoes(int threshold, int doubt) {
    CompiledCodeTest.compare(threshold, doubt, PROGRAM);
  }

  /** Each miss would be counted, and after a thousand the function be compiled again. */
  @Test
  void theyAreExpected() {
    String program =
        """
        function fresh() { Object.new }|; var own = Object.new|; function own.f(x) { x + 1 }|;
        function calls(n) { own.f(n) }|;
        fresh | fresh | calls(1) | calls(2);
        var before = System.tier["functions"]|;
        for| (var i : 5000) { fresh; calls(i) };
        System.tier["functions"] - before;
        """;
    String compiled = KernelSession.runCompiled(2, 0, 0, program);
    assertTrue(compiled.endsWith("] 0\n"), compiled);
  }
}
