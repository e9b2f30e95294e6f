package org.urbi.kernel.node;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/**
 * What a place in the code remembers of its lookups holds no longer than it is true. Each function
 * is called twice before something changes, so that it has something to forget.
 */
class LookupCacheTest {
  @Test
  void aNearerSlotIsSeen() {
    ConsoleTranscript.check(
        """
        class A { var x = 1; function get() { "A" } }|;
        var a = A.new|;
        var b = a.new|;
        function f() { [b.x, b.get] }|;
        f | f;
        [00000000] [1, "A"]
        var a.x = 2|;
        var a.get = function () { "a" }|;
        f;
        [00000000] [2, "a"]
        b.x = 3|;
        var b.get = function () { "b" }|;
        f;
        [00000000] [3, "b"]
        b.removeLocalSlot("x")|; b.removeLocalSlot("get")|;
        f;
        [00000000] [2, "a"]
        a.removeLocalSlot("x")|; a.removeLocalSlot("get")|;
        f;
        [00000000] [1, "A"]
        """);
  }

  @Test
  void aSlotThatHasGoneIsNotFound() {
    ConsoleTranscript.check(
        """
        class A { var x = 1 }|;
        var a = A.new|;
        function f() { a.x }|;
        f | f;
        [00000000] 1
        A.removeLocalSlot("x")|;
        f;
        [00000000:error] !!! 3.16-18: lookup failed: x
        [00000000:error] !!!    called from: 6.1: f
        var A.x = 2|;
        f;
        [00000000] 2
        """);
  }

  @Test
  void aSlotThatComesIsFound() {
    ConsoleTranscript.check(
        """
        class A {}|; class B { var y = 2 }|;
        var a = A.new|;
        function f(name) { try { a.x } catch (var e) { e.message } }|;
        f("x") | f("x");
        [00000000] "lookup failed: x"
        f("x");
        [00000000] "lookup failed: x"
        var A.x = 1|; f("x");
        [00000000] 1
        A.removeLocalSlot("x")|; f("x") | f("x");
        [00000000] "lookup failed: x"
        var a.x = 3|; f("x");
        [00000000] 3
        a.removeLocalSlot("x")|; f("x") | f("x");
        [00000000] "lookup failed: x"
        var Object.x = 4|; f("x");
        [00000000] 4
        Object.removeLocalSlot("x")|; f("x") | f("x");
        [00000000] "lookup failed: x"
        var B.x = 5|; f("x");
        [00000000] "lookup failed: x"
        A.addProto(B)|; f("x");
        [00000000] 5
        A.removeProto(B)|; f("x") | f("x");
        [00000000] "lookup failed: x"
        function A.fallback { "fallback of " + call.message }|; f("x");
        [00000000] "fallback of x"
        A.removeLocalSlot("fallback")|; f("x");
        [00000000] "lookup failed: x"
        for (var i : 70) a.setSlot("slot" + i, i); f("x") | f("x");
        [00000000] "lookup failed: x"
        var a.x = 6|; f("x");
        [00000000] 6
        var l = []|; function g(o) { try { o.x } catch { -1 } }|; g(l) | g(l);
        [00000000] -1
        var l.x = 1|; g(l);
        [00000000] 1
        var Float.x = 7|; [g(3), g([]), g(l)];
        [00000000] [7, -1, 1]
        Float.removeLocalSlot("x")|; g(3);
        [00000000] -1
        """);
  }

  @Test
  void aSlotThatHasMovedIsFound() {
    ConsoleTranscript.check(
        """
        class A { var x = 1; var y = 2; var z = 3 }|;
        var a = A.new|;
        function f() { [a.y, a.z] }|;
        f | f;
        [00000000] [2, 3]
        A.removeLocalSlot("x")|;
        f;
        [00000000] [2, 3]
        A.removeLocalSlot("y")|;
        var A.y = 4|;
        f;
        [00000000] [4, 3]
        """);
  }

  @Test
  void anAssignedSlotIsSeen() {
    ConsoleTranscript.check(
        """
        class A { var x = 1 }|;
        var a = A.new|;
        function f() { a.x }|;
        f | f;
        [00000000] 1
        A.x = 2|;
        f;
        [00000000] 2
        a.x = 3|;
        f;
        [00000000] 3
        A.x;
        [00000000] 2
        """);
  }

  @Test
  void otherPrototypesAreSeen() {
    ConsoleTranscript.check(
        """
        class A { var x = "A" }|;
        class B { var x = "B" }|;
        var mid = Object.new|;
        mid.protos = [A]|;
        var o = mid.new|;
        function f() { o.x }|;
        f | f;
        [00000000] "A"
        mid.protos = [B]|;
        f;
        [00000000] "B"
        mid.addProto(A)|;
        f;
        [00000000] "A"
        mid.removeProto(A)|;
        f;
        [00000000] "B"
        o.protos = [A]|;
        f;
        [00000000] "A"
        o.protos = []|;
        f;
        [00000000:error] !!! 6.16-18: lookup failed: x
        [00000000:error] !!!    called from: 17.1: f
        o.protos = [B, A]|;
        [00000000:error] !!! 18.1-8: lookup failed: protos
        f;
        [00000000:error] !!! 6.16-18: lookup failed: x
        [00000000:error] !!!    called from: 19.1: f
        """);
  }

  @Test
  void anotherFirstPrototypeOfAPrototypeIsSeen() {
    ConsoleTranscript.check(
        """
        class Left {}|;
        class Right { var x = "right" }|;
        class Both : Right {}|;
        Both.protos = [Left, Right]|;
        var o = Both.new|;
        function f() { o.x }|;
        f | f;
        [00000000] "right"
        var Left.x = "left"|;
        f;
        [00000000] "left"
        Left.removeLocalSlot("x")|;
        f;
        [00000000] "right"
        """);
  }

  @Test
  void whoSeesManyBuildsSeesEach() {
    ConsoleTranscript.check(
        """
        var all = []|;
        for| (var i : 12) { var o = Object.new; for| (var j : i) o.setSlot("s" + j, j); var o.x = i; all << o }|;
        function f(o) { o.x }|;
        all.map(closure (o) { f(o) });
        [00000000] [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]
        all.map(closure (o) { f(o) });
        [00000000] [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]
        all[3].x = "three"|;
        all[4].removeLocalSlot("s0")|;
        all.map(closure (o) { f(o) });
        [00000000] [0, 1, 2, "three", 4, 5, 6, 7, 8, 9, 10, 11]
        """);
  }

  @Test
  void aGetterIsCalledAndGoes() {
    ConsoleTranscript.check(
        """
        class A { var x = 1 }|;
        var a = A.new|;
        function f() { a.x }|;
        f | f;
        [00000000] 1
        A.setProperty("x", "get", function () { "got" })|;
        f; f;
        [00000000] "got"
        [00000000] "got"
        A.removeProperty("x", "get")|;
        f;
        [00000000] 1
        """);
  }

  @Test
  void aConstantIsNotAssigned() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        var o.x = 1|;
        function f(v) { o.x = v }|;
        f(2); f(3);
        [00000000] 2
        [00000000] 3
        var o.y = 1|;
        o.x->constant = true|;
        f(4);
        [00000000:error] !!! 3.17-19: cannot modify const slot
        [00000000:error] !!!    called from: 7.1-4: f
        o.x;
        [00000000] 3
        o.x->constant = false|;
        f(5);
        [00000000] 5
        """);
  }

  @Test
  void anOperatorOfOnesOwnIsSeen() {
    ConsoleTranscript.check(
        """
        function f(a, b) { a + b }|;
        f(1, 2); f(1, 2);
        [00000000] 3
        [00000000] 3
        class V { var v = 0; function '+'(o) { "V+" + o } }|;
        f(V.new, 3);
        [00000000] "V+3"
        var Float.plus = Float.getSlot("+")|;
        Float.removeLocalSlot("+")|;
        var Float.'+' = function (o) { "mine" }|;
        f(1, 2);
        [00000000] "mine"
        Float.setSlot("+", Float.getSlot("plus"))|;
        [00000000:error] !!! 9.1-41: slot redefinition: +
        do (Float) { removeLocalSlot("+")|; var '+' = getSlot("plus")|; }|;
        f(1, 2);
        [00000000] 3
        """);
  }

  @Test
  void aVariableOfTheLobbyIsSeenWhereverItIs() {
    ConsoleTranscript.check(
        """
        function f() { fresh }|;
        f;
        [00000000:error] !!! 1.16-20: lookup failed: fresh
        [00000000:error] !!!    called from: 2.1: f
        var Global.fresh = "global"|;
        f; f;
        [00000000] "global"
        [00000000] "global"
        var fresh = "lobby"|;
        f;
        [00000000] "lobby"
        removeLocalSlot("fresh")|;
        f;
        [00000000] "global"
        """);
  }

  @Test
  void slotsOfNumbersAndStrings() {
    ConsoleTranscript.check(
        """
        function f(o) { o.twice }|;
        f(3);
        [00000000:error] !!! 1.17-23: lookup failed: twice (possible misspelling of time)
        [00000000:error] !!!    called from: 2.1-4: f
        function Float.twice() { this * 2 }|;
        function String.twice() { this + this }|;
        f(3); f("a"); f(4);
        [00000000] 6
        [00000000] "aa"
        [00000000] 8
        Float.removeLocalSlot("twice")|;
        f(3); f("b");
        [00000000:error] !!! 1.17-23: lookup failed: twice (possible misspelling of time)
        [00000000:error] !!!    called from: 7.1-4: f
        [00000000] "bb"
        """);
  }

  @Test
  void aSlotThatIsUpdatedInPlaceIsTheObjectsOwn() {
    ConsoleTranscript.check(
        """
        class A { var count = 1 }|;
        var a = A.new|;
        function f() { a.count++; a.count += 10; a.count }|;
        f; f;
        [00000000] 12
        [00000000] 23
        A.count;
        [00000000] 1
        a.removeLocalSlot("count")|;
        A.count = 100|;
        f;
        [00000000] 111
        A.count;
        [00000000] 100
        """);
  }
}
