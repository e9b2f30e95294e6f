package org.urbi.tests;

import static java.util.Objects.requireNonNull;

import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Compiled functions that call nobody but themselves have no frames for that, until something needs
 * one; nobody can tell. What they call besides is what they have not called yet when they are
 * compiled.
 */
class OwnCallsTest {
  static Map<String, String> programs() {
    return Map.ofEntries(
        Map.entry(
            "errors have the places of all calls",
            """
            var o = Object.new|; var log = []|;
            function down(n) { if (n == 0) o.missing else 1 + down(n - 1) }|;
            down(0); down(1); down(3); down(120); down(400); try { down(5) } catch (var e) { echo(e.backtrace) };
            function two(n) {
              if (n == 0) nil.missing
              else if (n % 2 == 0)
                two(n - 1)
              else 1 +
                two(n - 1)
            }|;
            two(0); two(4); two(7);
            function sum(n) { if (n < 1) throw [n] else n + sum(n - 1) }|; sum(3); try { sum(4) } catch ([var x]) { x };
            function add(n, x) { if (n == 0) x else 1 + add(n - 1, x) }|; add(3, 1); add(3, "s"); add(3, nil); add(2, void);
            function use(n) { down(n) }|; function twice(n) { add(n, 1) + add(n, "s") }|; use(2); twice(2); twice(0); use(3);
            """),
        Map.entry(
            "what has been caught inside leaves nothing behind",
            """
            var o = Object.new|; var log = []|;
            function twice(n) {
              if (n == 0) o.missing;
              try { 1 + twice(n - 1) } catch (var e) { log << e.backtrace.size;
                2 + twice(n - 1) }
            }|;
            twice(0); twice(1); twice(2); twice(4); log; log = []|; try { twice(3) } catch (var e) { echo(e.backtrace) };
            function some(n) { if (n < 1) o.missing; if (n % 3 == 0) { try { some(n - 1) } catch (var e) { n } } else
              some(n - 1) + 1 }|;
            for (var i : 9) some(i); some(2);
            function fin(n) { try { if (n == 0) o.missing; fin(n - 1) } finally { log << n } }|; log = []|; fin(4); log;
            function again(n) { if (n == 0) throw "inner"; try { again(n - 1) } catch (var e) { throw [n, e] } }|; again(3);
            function looks(n) { if (n == 0) o.missing; try { looks(n - 1) } catch (var e) { throw } }|; looks(3);
            """),
        Map.entry(
            "the stack is exhausted, and used again",
            """
            function inf(n) { 1 + inf(n + 1) }|; function ok(n) { if (n < 1) 0 else 1 + ok(n - 1) }|;
            try { inf(0) } catch (var e) { echo(e.message); echo(e.backtrace.size) }; ok(10000); inf(0); ok(10000);
            function half(n) { try { half(n + 1) } catch (var e) { n > 100 } }|; half(0); half(0); ok(10);
            function last(n) { try { last(n + 1) } finally { n += 1 } }|; last(0); ok(5);
            """),
        Map.entry(
            "stops, and the others, come in between",
            """
            var t = Tag.new|; var log = []|; var o = Object.new|; function o.look(n) { log << n; sleep(1ms); n };
            function st(n) { if (n == 0) t.stop(7) else st(n - 1) + 1 }|; var r = { t: st(5) }|; r; { t: st(0) }; st(2);
            function turns(n, name) { log << name + n; if (n > 1) { turns(n - 1, name); turns(n - 2, name) } else n }|;
            turns(3, "a") & turns(4, "b"); log; log = []|; turns(3, "c"), turns(2, "d"), turns(1, "e"), sleep(5ms); log;
            function slow(n) { if (n > 0) { slow(n - 1); n += 1; slow(n - 2) }; o.look(n) }|; log = []|;
            t: slow(4), sleep(3ms)|; t.freeze; var size = log.size|; sleep(5ms)|; log.size == size; t.unfreeze; sleep(2ms)|;
            t.stop; sleep(5ms)|; log; log = []|; slow(3) & slow(2); log;
            function ends(n) { if (n == 0) { Tag.scope.stop(5); 6 } else ends(n - 1) + 1 }|; ends(3); ends(0); ends(3);
            function spin(n) { if (n < 2) n else { spin(n - 1); spin(n - 2) } }|;
            t: spin(60), sleep(0)|; t.stop; t: spin(60), sleep(0)|; t.freeze; t.stop; spin(5);
            """),
        Map.entry(
            "the function becomes another one while it runs",
            """
            function f(n) { if (n == 3) lobby.f = function (x) { 100 + x } | if (n < 1) 0 else 1 + f(n - 1) }|;
            var old = getSlotValue("f")|; f(2); f(5); f(5); f = old|; f(2); f(7);
            function g(n) { if (n == 2) lobby.removeLocalSlot("g") | if (n < 1) 0 else 1 + g(n - 1) }|; g(1); g(4); g(4);
            function h(n) { if (n < 1) 0 else h(n - 1) + 1 }|; var copy = getSlotValue("h").clone|; h(3); copy(3);
            h = copy|; h(3); var both = getSlotValue("h")|; both(4); h(2);
            function k(n) { if (n == 1) Float.'+' = function (x) { 42 } | if (n < 1) 0 else k(n - 1) + 1 }|;
            var plus = Float.getSlotValue("+")|; k(0); k(3); k(3); Float.'+' = lobby.getSlotValue("plus")|; k(0);
            function only(n) { if (n < 1) 0 else only(n - 1) }|; only(2); function only(n, m) { 5 }|; only(2); only(1, 2);
            """),
        Map.entry(
            "everything may be an answer",
            """
            function build(n) { if (n == 0) [] else [n, build(n - 1)] }|; build(0); build(3);
            function text(n) { if (n == 0) "" else text(n - 1) + "x" }|; text(4);
            function nothing(n) { if (n > 0) nothing(n - 1) }|; nothing(3); nothing(3) + 1;
            function none(n) { if (n == 0) nan else none(n - 1) }|; none(2); none(2) + 1; none(0) == none(1);
            function mixed(n) { if (n % 3 == 0) n else if (n % 3 == 1) [mixed(n - 1)] else "a" + mixed(n - 1) }|;
            for (var i : 7) echo(mixed(i)); mixed(nil); mixed("%s");
            function same(n, x) { if (n == 0) x else same(n - 1, x) }|; var a = 2.5|; same(3, a) === a; same(0, lobby) === lobby;
            function early(n) { if (n > 3) return "big"; if (n == 0) return; var r = early(n - 1); n }|;
            early(0); early(3); early(9);
            function ack(m, n) { if (m == 0) n + 1 else if (n == 0) ack(m - 1, 1) else ack(m - 1, ack(m, n - 1)) }|; ack(2, 3);
            function tak(x, y, z) { if (y >= x) z else tak(tak(x - 1, y, z), tak(y - 1, z, x), tak(z - 1, x, y)) }|; tak(8, 4, 2);
            var left = 5|; function zero { if (left == 0) "end" else { left -= 1; zero } }|; zero; left = 3|; zero() + "!"; left;
            function wrong(n) { if (n == 0) wrong(1, 2) else wrong(n - 1) }|; wrong(2); wrong(); wrong(void);
            """),
        Map.entry(
            "targets, slots and conditions are as ever",
            """
            class C {
              var k = 2;
              function f(n) { if (n < 1) k else f(n - 1) + k }; function me(n) { if (n < 1) this else me(n - 1) };
              function count(n) { k += n | if (n > 0) this.count(n - 1) };
              function sum(c) { if (c.isNil) 0 else k + c.sum(nil) };
            }|;
            var c = C.new|; c.f(3); c.me(3) === c; c.count(4)|; c.k; c.sum(c); c.k = "s"|; c.f(2); c.count(2); C.new.f(2);
            var d = C.new|; d.setSlot("f", function (n) { "own" })|; d.f(3); var d.extra = 1|; d.f(3); d.me(2) === d;
            d.removeLocalSlot("f")|; d.f(3); C.f = function (n) { if (n < 1) 1 else f(n - 1) * 2 }|; d.f(3); c.f(5);
            var x = 1|; function dep(n) { if (n == 0) x else dep(n - 1) }|; dep(2);
            at (dep(3) > 2) echo("more") onleave echo("less"); x = 5|; sleep(1ms); x = 0|; sleep(1ms); dep(3);
            """),
        Map.entry(
            "closures and unevaluated arguments have their activation",
            """
            var o = Object.new|; var saved = nil|; function o.keep { lobby.saved = call | 0 }|;
            function cl(n) { if (n > 0) { cl(n - 1) + n } else [1, 2].each(closure (y) { if (y == 2) return n + 7 }) }|;
            cl(0); cl(3); cl(3);
            function lz(n) { if (n == 0) o.keep(n += 1) else lz(n - 1); n }|; lz(2); saved.evalArgAt(0); saved.evalArgAt(0);
            lz(0); saved.sender === lobby; saved.evalArgAt(0); lz(3); saved.evalArgAt(0);
            var fs = []|; function mk(n) { if (n > 0) { mk(n - 1); fs << function () { n += 1 } } else 0 }|; mk(3);
            for (var f : fs) echo(f()); for (var f : fs) echo(f());
            function o.both { call.evalArgAt(0) + call.evalArgAt(0) };
            function ev(n) { if (n < 2) o.both(n += 1) else ev(n - 1) + n }|; ev(1); ev(4); ev(4);
            function back(n) { if (n == 0) o.keep(missing) else back(n - 1) }|; back(2); saved.evalArgAt(0);
            """));
  }

  @ParameterizedTest
  @MethodSource("names")
  void handMadeProgramsDoTheSame(String name) {
    int stack = name.contains("the stack is") ? 0 : CompiledCodeTest.SMALL_STACK;
    CompiledCodeTest.compare(name, stack, requireNonNull(programs().get(name)));
  }

  static Stream<String> names() {
    return programs().keySet().stream().sorted();
  }

  @Test
  void generatedProgramsDoTheSame() {
    CompiledCodeTest.compareGenerated(RecursiveProgramGenerator::program);
  }
}
