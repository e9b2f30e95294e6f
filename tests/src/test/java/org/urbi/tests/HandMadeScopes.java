package org.urbi.tests;

import java.util.Map;

/** Programs that leave scopes, loops and functions, or hand out code that others evaluate. */
final class HandMadeScopes {
  private HandMadeScopes() {}

  static Map<String, String> all() {
    return Map.ofEntries(
        Map.entry(
            "compiled loops are stopped, frozen and blocked",
            """
            var n = 0|; var t = Tag.new|;
            function count(most) { var i = 0; while (i < most) { i++; n = i; sleep(1ms) }; i }|;
            t: count(100),
            sleep(10ms)|; t.freeze; var at10 = n|; sleep(50ms)|; n == at10; t.unfreeze; sleep(5ms)|;
            t.stop(7); n < 30;
            var r = { t: { count(2); t.stop(8); count(3) } }|; r;
            count(3) & count(4); count(3), count(5), sleep(20ms); n;
            function spin(most) { var i = 0; while (i < most) { i += 1 }; n = i }|;
            t: spin(1e9), sleep(0); t.stop; n;
            """),
        Map.entry(
            "unevaluated arguments see and change variables",
            """
            var saved = nil|; function keep { saved = call | 0 }|;
            function f(n) {
              var i = 0; keep(i); keep(i += 10);
              while| (i < n) { i += 1 | if (i == 3) saved.evalArgAt(0) };
              keep(i * 2); i = 100; echo(saved.evalArgAt(0)); i
            }|;
            f(5); f(20); saved.evalArgAt(0);
            function g() { var c = 0; keep(c++); sleep(2ms); c + 1 }|;
            g, sleep(1ms)|; saved.evalArgAt(0); sleep(3ms)|; { g } & { sleep(1ms); saved.evalArgAt(0) };
            """),
        Map.entry(
            "jumps leave loops from everywhere",
            """
            function f(n) {
              var log = [];
              for| (var i : n) {
                for (var j : n) {
                  if (j == 1) continue; if (j == 3) break;
                  try { if (i == 2) continue; if (i == 4) break; if (i == 5) return log }
                  finally { log << "f" };
                  switch (j) { case 0: continue; case 2: log << 2 };
                  log << i * 10 + j
                };
                for| (var e : [1, "x", 3]) { if (e == 3) break | log << e };
                [1, 2].each(function (e) { log << e });
                while (true) { detach({ sleep(1ms) | log << "never" }); if (i < 9) break }
              };
              log
            }|;
            f(3); f(4); f(7); var l = f(2)|; sleep(5ms)|; l;
            """),
        Map.entry(
            "what is added to a scope is done when that is left",
            """
            function alive(t) { detach({ t: { sleep(10ms) | echo("alive") } }) | 1 }|;
            class Ring { var all = nil; function init(l) { all = l }; function each(f) { for (var x : all) f(x) } }|;
            class L { function '+' { call.evalArgAt(0) }; function '==' { call.evalArgAt(0) } }|; var tag = nil|;
            function a(r, e) { var n = 0; { for (var x : r) scopeTag: at (x?(var v)) n += v; e!(1) }; e!(10); sleep(1ms); n }|;
            var e = Event.new|; a(Ring.new([e]), e); a(Ring.new([e]), e); a(Ring.new([e]), e);
            function b(o) { { alive(o + scopeTag); 1 }; { alive(o == scopeTag) | 2 }; sleep(20ms) }|; b(L.new); b(L.new); b(L.new);
            function c(n) { { try { throw n } catch (lobby.tag = scopeTag) { 1 } catch (var x) { alive(tag) }; 1 }; sleep(20ms) }|;
            c(1); c(2); function d(n) { { switch (n) { case (lobby.tag = scopeTag): 1; default: alive(tag) } }; sleep(20ms) }|; d(1); d(2);
            """),
        Map.entry(
            "code that was handed out adds to the scope that evaluates it",
            """
            var kept = nil|; function keep { lobby.kept = call | 0 }|; function again() { kept.evalArgAt(0) }|; var tag = nil|;
            function alive(t) { detach({ t: { sleep(10ms) | echo("alive") } }) | 1 }|; function nap() { sleep(5ms) | 1 }|;
            class V { function take { lobby.tag = kept.evalArgAt(0) | this }; function '+'(x) { take }; function '[]'(x) { take | 0 };
              function '[]='(x, y) { take | 0 }; function asBool { take | true }; set p(x) { take }; get p { 1 } }|;
            function a(n) { keep(scopeTag); { alive(again()); 1 }; sleep(20ms) }|; a(1); a(2); a(3);
            function b(o) { keep(scopeTag); { o.p = 1; alive(tag); 1 }; { o.p += 1; alive(tag); 1 }; sleep(20ms) }|; b(V.new); b(V.new);
            function c(o) { keep(scopeTag); { o[1] += 1; alive(tag); 1 }; { if (o) 1; alive(tag); 1 }; { o += 1; alive(tag); 1 };
              sleep(20ms) }|; c(V.new); c(V.new); c(V.new);
            function d(n) { keep(scopeTag); { var x = nap(); x += 1 }; sleep(30ms) }|;
            function e(n) { detach(d(n)) | sleep(2ms) | alive(kept.evalArgAt(0)) | sleep(40ms) }|; e(1); e(2); e(3);
            """),
        Map.entry(
            "break ends the jobs that a loop has detached",
            """
            class D {}|; D.setSlot("<<", System.getSlotValue("detach"))|; function late(n) { sleep(10ms) | echo(n) }|;
            var kept = nil|; function keep { lobby.kept = call | 0 }|; function again { kept.evalArgAt(0) }|;
            function go() { late(1) }|;
            function a { var i = 0 | while| (i < 3) { D << go | if (i == 1) break | i += 1 } | sleep(20ms) }|; a; a; a;
            function b(n) { keep(detach(late(2))); for (var i : n) { again; if (i == 1) break }; sleep(20ms) }|; b(3); b(3); b(3);
            class P { get p { kept.evalArgAt(0) | 1 } }|;
            function c(o) { keep(detach(late(3))); for (var i : 3) { o.p; if (i == 1) break }; sleep(20ms) }|; c(P.new); c(P.new);
            function lazy { var c = call; function () { c.evalArgAt(0) } }|;
            function d(n) { var go = lazy(detach(late(4))); for (var i : n) { go(); if (i == 1) break }; sleep(20ms) }|; d(3); d(3); d(3);
            """),
        Map.entry(
            "what is thrown is caught, passed on and tidied up after",
            """
            class E : Exception { var n = 0 }|; class Other : Exception {}|;
            function f(n) {
              if (n == 0) throw E.new; if (n == 1) throw 1; if (n == 2) missing; if (n == 3) throw [1, 2];
              if (n == 4) f(4); if (n == 5) throw Other.new("other"); n
            }|;
            function g(n) {
              var a = n; var log = [];
              try { a += 1; log << "body"; a = f(n); log << "over" }
              catch (var e if e.isA(E)) { a += 10; log << "E" }
              catch (1) { a += 20; log << "one" }
              catch ([var x, var y]) { a = x + y; log << "list" }
              catch (var e if e.isA(Other)) { log << e.message; a = 7 }
              else { log << "else"; a += 100 };
              [a, log]
            }|;
            g(0); g(1); g(2); g(3); g(5); g(6); g("s"); g(nil); g(2); g(4);
            function h(n) { var k = 0; try { try { k += 1; f(n); k += 2 } finally { k += 4; echo("k" + k) } } catch (var e) { k += 8 }; k }|;
            for (var i : 7) h(i); h(0); h(6); h(4);
            function only(n) { var k = n; try { k = f(n) } finally { echo(k) } }|; only(0); only(6); only(1); only(2);
            function again(n) { try { f(n) } catch (var e) { try { f(1) } catch (1) { throw } } }|; again(0); again(5); again(6); again(2);
            function rethrow(n) { try { f(n) } catch { throw } }|; rethrow(0); rethrow(1); rethrow(3); rethrow(5);
            function inGuard(n) { try { f(n) } catch (var e if missing) { 1 } }|; inGuard(1); inGuard(1); inGuard(6);
            function inPattern(n) { try { f(n) } catch (missing) { 1 } }|; inPattern(1); inPattern(6);
            function inElse(n) { try { n } catch { "caught" } else { f(1) } }|; inElse(1); try { inElse(1) } catch (var e) { e };
            function inFinally(n) { try { f(n) } finally { missing } }|; inFinally(0); inFinally(6);
            """),
        Map.entry(
            "jumps leave what handles exceptions",
            """
            function out(n) { for (var i : 10) { try { if (i == n) return "returned" + i; throw i }
              catch (var e) { if (e == 3) continue; if (e == 5) break; if (e == 4 && n == 6) return ["caught", e] } }; n }|;
            out(0); out(2); out(4); out(6); out(9); out(7);
            function bare(n) { for (var i : 4) { try { throw i } catch (var e) { if (i == n) break; if (i == 1) continue } }; throw n }|;
            bare(0); bare(1); bare(9);
            function deep(n) { try { throw "outer" } catch (var o) { while (true) { try { throw n } catch (var e) { if (n == 1) break; return e } };
              try { throw } catch (var x) { [o, x] } } }|; deep(1); deep(2); deep(1);
            function last(n) { for (var i : 3) { try { if (i == n) continue; if (i == 2) break } finally { echo("f" + i) } }; "end" }|;
            last(0); last(1); last(5); function ret(n) { try { return n } finally { echo("last " + n) } }|; ret(1); ret(2); ret(nil);
            function each(l) { var sum = 0; l.each(closure (x) { try { if (x == 2) throw x; sum += x } catch (var e) { sum += 100 } }); sum }|;
            each([1, 2, 3]); each([2, 2]); each([]);
            function loops(n) { var i = 0; var c = 0; while (i < n) { i += 1; try { if (i % 3 == 0) throw i; c += 1 } catch (var e) { c += e } }; [i, c] }|;
            loops(10); loops(20); loops(0);
            """),
        Map.entry(
            "a stop goes through what handles exceptions",
            """
            var t = Tag.new|; var seen = []|;
            function forEver(n) { try { try { while (true) { n += 1; sleep(1ms) } } catch (var e) { seen << e } finally { seen << "tidy"; sleep(1ms); seen << n } } finally { seen << "last" } }|;
            t: forEver(1), sleep(5ms)| t.stop; sleep(3ms); seen.size; seen[0]; t: forEver(1), sleep(5ms)| t.stop; sleep(3ms); seen.size;
            function stops(n) { t: { try { t.stop(n) } catch { "never" } finally { echo("tidied") } } }|; stops(3); stops(4); stops(5);
            function frozen(n) { try { if (n) t.freeze; t: { n = 2 }; n } catch { 1 } finally { echo("over") } }|; frozen(false);
            function deep(n) { try { deep(n + 1) } catch (var e if e.isA(Exception.Scheduling)) { n > 100 } }|; deep(0); deep(0);
            function over(n) { var a = n; try { a += 1; missing; a = 0 } catch (var e) { throw [a] } }|; try { over(1) } catch ([var a]) { a }; try { over(2) } catch ([var a]) { a };
            var w = Object.new|; var w.v = 1|;
            function watched(n) { try { if (w.v > n) throw 1; 0 } catch (1) { w.v } }|; watched(0); watched(0); at (watched(1) == 2) echo("two"); w.v = 2|; sleep(1ms); w.v = 0|; sleep(1ms);
            function lazy(n) { var a = n; try { function q { call.evalArgAt(0) }; q({ a += 1; if (a > 2) throw a; a }) } catch (var e) { [a, e] } }|; lazy(1); lazy(2); lazy(2);
            function shared(n) { var a = n; var add = function () { a += 1; if (a > 2) throw a; a }; try { add() } catch (var e) { [a, e] } }|; shared(1); shared(2); shared(2);
            """),
        Map.entry(
            "arguments that are evaluated later assign variables",
            """
            function later { var c = call | detach({ sleep(3ms) | c.evalArgAt(0) }) | 0 }|;
            function before(a) { later(a = nan); for (var i : 30) { sleep(1ms); a += 1 }; a }|;
            before(1); before(2); before(3);
            function given(a, b = later(a = nan)) { var i = 0; while (i < 30) { i++; sleep(1ms); a += 1 }; a }|;
            given(1); given(2); given(3);
            { var a = 1; later(a = nan); for (var i : 30) { sleep(1ms); a += 1 }; a };
            { var a = 1; for (var k : 3) { for (var i : 30) { sleep(1ms); a += 1 }; echo(a); later(a = k) } };
            detach({ var a = 1; var i = 0; while (i < 30) { i += 1; sleep(1ms); if (i == 3) later(a = nan); a += i }; echo(a) })|; sleep(50ms);
            var t = Tag.new|;
            function tidied(a) { later(a = "late"); for| (var i : 2) { try { sleep(2ms) } finally { echo(a + i) } }; a }|;
            for (var i : 4) { t: tidied(i), sleep(3ms)|; t.stop; sleep(3ms) };
            function caught(a) { later(a = "late"); try { sleep(4ms); throw a } catch (var e) { [e, a] } }|;
            function inside(a) { later(a = "late"); try { for (var i : 9) { sleep(1ms); if (i == 4) throw i } } catch (var e) { [e, a] } }|;
            for (var i : 3) { echo(caught(i)); echo(inside(i)) };
            """),
        Map.entry(
            "a branch hands out an argument, and the other one has its own variables",
            """
            function later { var c = call | detach({ sleep(3ms) | c.evalArgAt(0) }) | 0 }|;
            function f() {
              { var i = 0| while (i < 4) { i++| echo(i); } }
              & { var v = 1; { var j = 0| while| (j < 1) { j++| later(v = j)| } } }
            }|;
            f(); f();
            function g() {
              var a = 1;
              { while (a < 4) { a++| echo(a); } }, { later(a = 9)| sleep(5ms)| echo(a) }, sleep(9ms); a
            }|;
            g(); g();
            """),
        Map.entry(
            "a jump ends the clause that is executed because of an exception",
            """
            function inside(n) {
              for| (var i = 0; i < n; i++) {
                try { try { throw i } finally { if (i < 3) { break } } }
                catch (var e) { echo("caught %s" % e); echo("second") }
              };
              echo("after"); 1
            }|;
            inside(2); inside(2); inside(5);
            function outside(n) {
              try { for| (var i : n) { try { throw i } finally { continue } }; echo("behind") }
              catch (var e) { echo("caught %s" % e); echo("second") };
              echo("after"); 2
            }|;
            outside(2); outside(2);
            function returned { try { try { throw 1 } finally { return 3 } } catch (var e) { echo("caught"); echo("second"); 4 } }|;
            returned; returned;
            function ended { try { return 1 } finally { for (var i : 2) { try { throw i } catch (var e) { echo(e) } finally { continue } } } }|;
            ended; ended;
            """),
        Map.entry(
            "a function without parameters, which may ask for its call, has been handed nothing",
            """
            var o = Object.new|; function o.start { 1 }|; function begin { call.evalArgs.size }|;
            function f(n) { var v = 5; if (n == 3) o.start| { { 1 } & { 2 } } | v * 2 }|; f(2); f(3); f(3);
            function g(n) { var v = n; if (n == 3) begin| { 1, 2 } | v * 2 }|; g(2); g(3); g(3);
            function h(n) { if (n < 1) return 7; var v = h(n - 1); if (n == 3) o.start| { { 1 } & { sleep(1ms) } }| v * 2 }|;
            h(2); h(3); h(4);
            """));
  }
}
