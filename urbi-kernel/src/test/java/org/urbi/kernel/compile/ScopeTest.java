package org.urbi.kernel.compile;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** Names, scopes and what code is made of (manual, "Scopes", "Functions", "Syntactic sugar"). */
class ScopeTest {
  @Test
  void variablesOfAScopeHideThoseAround() {
    ConsoleTranscript.check(
        """
        var x = 1|;
        { var x = 2; { var x = 3; echo(x) }; echo(x); x = 4; echo(x) };
        [00000000] *** 3
        [00000000] *** 2
        [00000000] *** 4
        x;
        [00000000] 1
        { x = 5 };
        [00000000] 5
        x;
        [00000000] 5
        { var y = 1; { y = 2 }; echo(y) };
        [00000000] *** 2
        y;
        [00000000:error] !!! 7.1: lookup failed: y
        """);
  }

  @Test
  void functionsSeeTheirVariablesNotThoseOfTheCaller() {
    ConsoleTranscript.check(
        """
        var x = "lobby"|;
        function f() { x }|;
        { var x = "local"; echo(f) };
        [00000000] *** lobby
        function outer() { var n = 0; function inner() { n = n + 1; n }; inner(); inner(); n }|;
        outer; outer;
        [00000000] 2
        [00000000] 2
        function make(n) { closure (k) { n = n + k } }|;
        var add = make(10)|;
        var other = make(100)|;
        add(1); add(2); other(1); add(3);
        [00000000] 11
        [00000000] 13
        [00000000] 101
        [00000000] 16
        """);
  }

  @Test
  void turnsOfALoopHaveVariablesOfTheirOwn() {
    ConsoleTranscript.check(
        """
        var all = []|;
        for| (var i : 3) { var j = i * 10; all << closure () { "%s %s" % [i, j] } }|;
        all.map(closure (c) { c() });
        [00000000] ["0 0", "1 10", "2 20"]
        for (var i = 0; i < 3; i++) echo(i);
        [00000000] *** 0
        [00000000] *** 1
        [00000000] *** 2
        i;
        [00000000:error] !!! 5.1: lookup failed: i
        """);
  }

  @Test
  void closuresKeepThisAndFunctionsDoNot() {
    ConsoleTranscript.check(
        """
        class A { var n = 1; function f() { closure () { n } }; function g() { function () { n } } }|;
        var n = "lobby"|;
        var a = A.new|;
        var c = a.f|;
        var g = a.g|;
        c();
        [00000000] 1
        g();
        [00000000] "lobby"
        """);
  }

  @Test
  void argumentsAreVariables() {
    ConsoleTranscript.check(
        """
        function f(a, b = a + 1, c[]) { a = a * 2; [a, b, c] }|;
        f(1); f(1, 5); f(1, 5, 6, 7);
        [00000000] [2, 2, []]
        [00000000] [2, 5, []]
        [00000000] [2, 5, [6, 7]]
        function lazy { call.argsCount }|;
        lazy(1, 2, missing);
        [00000000] 3
        function twice { call.evalArgAt(0) + call.evalArgAt(0) }|;
        var k = 0|;
        twice(k++);
        [00000000] 1
        """);
  }

  @Test
  void operatorsBindAsTheManualSays() {
    ConsoleTranscript.check(
        """
        1 + 2 * 3 ** 2; -2 ** 2; (1 + 2) * 3; 10 - 3 - 2; 2 ** 3 ** 2;
        [00000000] 19
        [00000000] -4
        [00000000] 9
        [00000000] 5
        [00000000] 512
        1 < 2 && 2 < 3 || missing; !true || true; 1 + 1 == 2; 7 % 4 * 2;
        [00000000] true
        [00000000] true
        [00000000] true
        [00000000] 6
        var x = 5|;
        x += 2; x -= 1; x *= 3; x /= 2; x++; x; x--; x; ++x;
        [00000000] 7
        [00000000] 6
        [00000000] 18
        [00000000] 9
        [00000000] 9
        [00000000] 10
        [00000000] 10
        [00000000] 9
        [00000000:error] !!! 4.49-50: syntax error: unexpected ++
        "a" + 1 + 2; 1 in [1]; 2 not in [1]; 1 ~= 1.00001; 1 === 1;
        [00000000] "a12"
        [00000000] true
        [00000000] true
        [00000000] true
        [00000000] false
        """);
  }

  @Test
  void jumpsLeaveTheNearestLoop() {
    ConsoleTranscript.check(
        """
        for| (var i : 5) { if (i == 1) continue; if (i == 3) break; echo(i) };
        [00000000] *** 0
        [00000000] *** 2
        for| (var i : 2) { for| (var j : 3) { if (j == 1) break; echo("%s %s" % [i, j]) } };
        [00000000] *** 0 0
        [00000000] *** 1 0
        var n = 0|;
        while (true) { n++; if (n == 3) break };
        n;
        [00000000] 3
        loop { n++; if (9 < n) break };
        n;
        [00000000] 10
        function f() { for| (var i : 5) { if (i == 2) return i } ; "end" }|;
        f;
        [00000000] 2
        """);
  }

  @Test
  void switchAndPatternsBind() {
    ConsoleTranscript.check(
        """
        function f(v) { switch (v) { case 1: "one"; case [var a, 2]: a; case ["k" => var b]: b; case "x" if false: "never"; default: "default" } }|;
        f(1); f([7, 2]); f([7, 3]); f(["k" => 8]); f("x");
        [00000000] "one"
        [00000000] 7
        [00000000] "default"
        [00000000] 8
        [00000000] "default"
        [var z, 1] = [2, 3];
        [00000000:error] !!! 3.1-19: pattern did not match
        """);
  }

  @Test
  void exceptionsAreCaughtByPatterns() {
    ConsoleTranscript.check(
        """
        try { throw 1 } catch (2) { "two" } catch (var x if x == 1) { "one %s" % x } catch { "any" };
        [00000000] "one 1"
        try { throw "s" } catch (1) { } catch { "any" };
        [00000000] "any"
        try { 1 } catch (var e) { 2 } else { 3 };
        [00000000] 3
        try { echo("body") } finally { echo("finally") };
        [00000000] *** body
        [00000000] *** finally
        try { try { throw 5 } finally { echo("cleanup") } } catch (var e) { e };
        [00000000] *** cleanup
        [00000000] 5
        function f() { try { return "returned" } finally { echo("left") } }|;
        f;
        [00000000] *** left
        [00000000] "returned"
        """);
  }

  @Test
  void whatFollowsASemicolonLetsOthersRunAndABarDoesNot() {
    ConsoleTranscript.check(
        """
        { { echo("a1"); echo("a2") } & { echo("b1"); echo("b2") } };
        [00000000] *** a1
        [00000000] *** b1
        [00000000] *** a2
        [00000000] *** b2
        { { echo("a1") | echo("a2") } & { echo("b1") | echo("b2") } };
        [00000000] *** a1
        [00000000] *** a2
        [00000000] *** b1
        [00000000] *** b2
        { { sleep(1s) | echo("late") }, echo("early"); echo("end of scope waits") };
        [00000000] *** early
        [00000000] *** end of scope waits
        [00001000] *** late
        echo("after");
        [00001000] *** after
        """);
  }
}
