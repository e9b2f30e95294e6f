package org.urbi.tests;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

/** Programs that do what random ones hardly ever do, for {@link CompiledCodeTest}. */
final class HandMadePrograms {
  private HandMadePrograms() {}

  /** All programs, those of scopes too, by their names. */
  static SortedMap<String, String> all() {
    SortedMap<String, String> all = new TreeMap<>(HandMadeScopes.all());
    all.putAll(ofValues());
    return all;
  }

  private static Map<String, String> ofValues() {
    return Map.ofEntries(
        Map.entry(
            "only another job has the variables",
            """
            var o = Object.new|; var o.x = 1|; var event = Event.new|;
            function f() {
              { event = Event.new |
                { timeout (3ms) { waituntil (event?(var seen)) |
                    { if (!seen.hasLocalSlot("tag")) echo(seen) } } }
                & { event!(o.x < o.x) } | sleep(1ms) }|
              { { var before = o.x; if (1 < o.get(o.x) || o.x > 2) {}| }, sleep(1ms) }|
            }|;
            function g(a, b) { o.x = (c = f()) }|;
            f(); f(); f();
            g(1, 2);
            """),
        Map.entry(
            "an operator is redefined, and removed, while a loop runs",
            """
            var plus = Float.getSlotValue("+")|;
            function f(n) {
              var i = 0; var sum = 0;
              while| (i < n) {
                sum = sum + 1 | i += 1 |
                if (i == 3) Float.'+' = function(x) { 42 } |
                if (i == 5) Float.'+' = lobby.getSlotValue("plus") |
                if (i == 7) Float.removeLocalSlot("+")
              };
              sum
            }|;
            f(6); f(6); f(9); Float.setSlot("+", getSlotValue("plus"))|; f(2);
            """),
        Map.entry(
            "a class that defines an operator does not change numbers",
            """
            function f(a, b) { if (a < b) a + b else a - b }|;
            f(1, 2); f(2, 1);
            class V { function '+'(o) { "plus" }; function '<'(o) { true } }|;
            f(1, 2); f(V.new, 2); f(1, 2);
            """),
        Map.entry(
            "numbers have an identity and slots",
            """
            function f(n) {
              var a = n + 1; var b = a; var c = n + 1;
              echo(a === b); echo(a === c); echo(b.uid == a.uid); echo(n === n);
              a.setSlot("name", "one"); echo(b.name); b += 1; echo(a + 1); echo(b.hasSlot("name"));
              var old = a++; echo(old.name); echo(old === b); [a, old, (a = 3) + (a = 4), a + (a = 5)]
            }|;
            f(1); f(2); f(0.5);
            """),
        Map.entry(
            "divisions have their errors and signs",
            """
            function f(a, b) { echo(a % b); echo(a ** b); a / b }|;
            function zero(a) { a / 0 }|; function rest(a) { a % 0 }|;
            function half(a) { a / 2 + a % 2 }|;
            f(7, 2); f(-7, 2); f(7, -2); f(1, 0); f(0, 0); f(1, 0.5); f(inf, 3); f(nan, nan);
            zero(1); zero("s"); rest(1); rest("%s"); half(3); half("s"); half(nil); half(-5);
            var over = Float.getSlotValue("/")|; Float.'/' = function(x) { "over" }|; half(3); zero(1);
            Float.'/' = lobby.getSlotValue("over")|; half(3); zero(1); f(1, "s"); f(void, 1); f(1, void);
            """),
        Map.entry(
            "the stack is exhausted in compiled functions",
            """
            function down(n) { 1 + down(n + 1) }|;
            function even(n) { odd(n + 1) }|; function odd(n) { for| (var i : 1) { even(n) } }|;
            try { down(0) } catch (var e) { echo(e.message) };
            try { even(0) } catch (var e) { echo(e.message) };
            down(0);
            """),
        Map.entry(
            "calls have frames only for those who look",
            """
            function same(x) { x }|; function add(a, b) { a + b }|; function target { this }|;
            function user(n) { var a = n + 1; echo(same(a) === a); same(a + 1) + add(a, a) }|;
            for (var i : 3) echo(user(i)); user("a"); target === this; same(void);
            function lazily { call.evalArgAt(0) + call.evalArgAt(0) }|;
            function exposed(n) { lazily(n += 1) + n }|; exposed(1); exposed(2); exposed("a");
            var kept = nil|; function keep { kept = call | 0 }|;
            function leaks(n) { if (n < 0) keep(n); n }|;
            leaks(1); var left = leaks(-5)|; kept.evalArgAt(0) === left;
            function fails(n) { if (n == 3) nobody(n) else if (n == 5) throw n else n }|;
            function outer(n) { fails(n) + 1 }|;
            for (var i : 7) { try { echo(outer(i)) } catch (var e) { echo(e) } }; outer(3); outer(5);
            function find(list, x) { for| (var y : list) { if (y == x) return y }; nil }|;
            function first(x) { [1, 2, 3].each(closure (y) { if (y == x) return y }); find([x], x) }|;
            function both(x) { first(x) + find([x], x) }|; both(2); both(9); both(3);
            function g(x) { x }|; function h(n) { g({ lobby.g = function (x) { [x] } | n }) }|; h(1); h(2);
            var ended = Tag.new|; function scoped(n) { ended: { if (n == 2) ended.stop(n); n + 1 } }|;
            function around(n) { scoped(n) * 2 }|; around(1); around(2); around(3);
            """),
        Map.entry(
            "closures of one text share code, not variables",
            """
            function counter(step) { var count = 0; function () { count += step; count } }|;
            function run(n) {
              var a = counter(1); var b = counter(10); var sum = 0;
              for| (var i : n) { sum += a() + b() };
              sum
            }|;
            run(3); run(20);
            function twice(f, x) { f(f(x)) }|; class Other { var name = "other" }|;
            for (var i : 3) echo(twice(function (x) { x * 2 + i }, i));
            twice(closure (x) { [this === lobby, x] }, "a"); twice(function (x) { nobody + x }, 1);
            twice(function (a, b) { a }, 1); twice(3, 1); twice(function (x, y = 2) { x + y }, 1);
            Other.setSlot("twice", getSlotValue("twice"))|; Other.twice(function (x) { [name, x] }, 1);
            function compose(f, g) { function (x) { f(g(x)) } }|;
            var one = function (x) { x + 1 }|; var all = compose(&one, compose(&one, &one))|;
            for (var i : 4) echo(all(i)); all("a"); all(nil);
            function until(n) { var i = 0; var next = function () { if (i < n) i += 1 else throw i }; loop next() }|;
            try { until(5) } catch (var e) { echo(e) }; until(3);
            """),
        Map.entry(
            "variables are seen after an exception has left loops inside of loops",
            """
            function pairs(n) {
              var sum = 0;
              for (var i : n) { for| (var j = i; j < n; j += 1) { sum += i * j } };
              sum
            }|;
            for (var n : 30) pairs(n % 5); pairs(20);
            function until(list, end) {
              var i = 0; var last = nil;
              try {
                while (i < 9) {
                  for (var x : list) { last = x; if (i + x == end) throw last; i += 0.5 };
                  i += 1
                }
              } catch (var e) { echo("%s %s %s" % [i, last, e]) };
              [i, last]
            }|;
            for (var k : 30) until([1, 2, 3], k / 2);
            var tag = Tag.new|; var seen = nil|;
            function stopped(n) {
              var i = 0; var j = 0;
              tag: while (true) { for (j = 0; j < n; j++) { i += 1; if (i == 5 * n) tag.stop } };
              seen = [i, j]
            }|;
            for (var n : 30) { stopped(1 + n % 4); echo(seen) };
            function left(n) {
              for (var i : n) { for (var j : n) { if (j == 3) continue; if (i * j == 8) return [i, j] } };
              [n]
            }|;
            for (var n : 30) echo(left(n % 7));
            for (var i : 40) { for (var j : 3) { for (var k : 2) { if (i * j * k == 70) i.nowhere } } };
            """),
        Map.entry(
            "entries of dictionaries and elements of lists are counted",
            """
            function count(d, keys) {
              for (var k : keys) { if (d.has(k)) d[k] += 1 else d[k] = 1 };
              for (var k : keys) { d[k]++; echo(d[k] -= 0.5) };
              d
            }|;
            count([=>], ["a", "b", "a", 1, 1, -0, 0]); count([=>], [nil]); count([=>], [[1], [1]]);
            function bump(l, n) { for (var i : n) { l[i % 3] += i; l[-1]--; l[i] = l[i] ** 2 }; l }|;
            bump([1, 2, 3], 3); bump([1, 2, 3], 4); bump(["a", "b", "c"], 1); bump("abc", 1);
            bump([0 => 1, 1 => 2], 2); bump([0 => 1, -1 => 1, 1 => 2], 2); count([=>], ["x"])["y"] += 1;
            var told = [=>]|; at (told.elementAdded?) echo("added"); at (told.elementChanged?) echo("changed");
            count(told, ["a", "a"]); sleep(0)|;
            class Sums: Dictionary { function '[]='(k, v) { echo("set " + k); v } }|;
            count(Sums.new(), ["a"]);
            var plain = Dictionary.getSlotValue("[]=")|;
            function swapped(d) {
              for (var i : 6) {
                d["k"] += i; if (i == 2) Dictionary.'[]=' = function(k, v) { echo("mine") };
                if (i == 4) Dictionary.'[]=' = lobby.getSlotValue("plain")
              };
              d
            }|;
            swapped(["k" => 0]); swapped(["k" => 0]);
            var watched = ["n" => 0]|; at (watched["n"] > 5) echo("more than 5");
            function add(d, n) { for (var i : n) d["n"] += 1 }|; add(watched, 4); add(watched, 4);
            """),
        Map.entry(
            "a function is called first where the stack is nearly exhausted",
            """
            function first(n) { var sum = 0; for| (var i : 3) { sum += i * n }; sum }|;
            function down(n) { try { down(n + 1) } catch (var e) { first(1) } }|;
            down(0); first(2); down(0);
            """),
        Map.entry(
            "conditions see what compiled functions read",
            """
            var x = 0|; var o = Object.new|; var o.y = 0|;
            function both(n) { if (x + o.y > n) true else false }|;
            both(1); both(1); both(1);
            at (both(1)) echo("on") onleave echo("off");
            x = 1; o.y = 1; o.y = 0; x = 5; x = 0;
            function set(v) { x = v | o.y = v }|; set(1); set(0); set(2); set(0);
            """),
        Map.entry(
            "numbers in slots are objects as soon as somebody sees them",
            """
            class P { var x = 0; var y = 1; function init() { var this.x = 0; var this.y = 1 } }|;
            function turn(p, n) { p.x = p.x + 1; p.y -= p.x * n; p.x += 2 * n; p.x++; p.x - p.y / 2 }|;
            function same(p) { var a = p.x; var b = p.x; a === b && a === p.x && a.uid == p.x.uid }|;
            function kept(p) { var a = p.x; p.x += 1 | p.x -= 0.5; [a, p.x, a === p.x] }|;
            function stored(p, n) { p.x = n; p.x === n }|;
            function ratio(p) { p.x / p.y + p.x % p.y }|;
            var p = P.new|; var q = P.new|;
            for (var i : 5) { echo(turn(p, i)); echo(same(p)); echo(kept(p)); echo(stored(q, i)) };
            p.x.setSlot("name", "one"); p.x.name; turn(p, 1); p.x.hasSlot("name"); same(p);
            q.y = 0|; ratio(p); ratio(q); q.y = nan|; ratio(q); q.y = "s"|; ratio(q); turn(q, 2);
            q.y = 1|; q.x = "text"|; turn(q, 2); q.x; q.x = nil|; turn(q, 2); q.x = 3|; turn(q, 2); same(q);
            at (p.x > 20) echo("much") onleave echo("little"); p.x = 30|; sleep(1s); turn(p, -20); sleep(1s);
            p.removeLocalSlot("x"); turn(p, 1); turn(q, 1); kept(p);
            p.x = 5|; function p.x() { 7 }; turn(p, 1); kept(p); const var q.z = 1; function z(o) { o.z -= 1; o.z }|; z(q);
            var r = P.new|; r.addProto(Object.new); r.setSlot("w", 2); turn(r, 3); same(r); turn(4, 5);
            var minus = Float.getSlotValue("-")|; Float.'-' = function(o) { [this === r.y, o] }|; turn(r, 1);
            r.y = 2|; turn(r, 1); r.y; Float.'-' = lobby.getSlotValue("minus")|; turn(r, 1); r.y = 2|; turn(r, 1);
            """),
        Map.entry(
            "slots are where they were, until they are elsewhere",
            """
            class P {
              var v = 1;
              function get() { v }; function set(n) { v = n }; function inc() { v += 1 };
              function plus(a, b) { a + b + v }; function none() {};
            }|;
            var p = P.new|; var q = P.new|;
            function f(o, n) {
              o.set(n) | o.inc() | var old = o.v++ | o.v += 2 | o.none() |
              [o.get(), o.plus(n, 1), o.v, old, o.v === o.v, o.plus(old, o.v -= 1)]
            }|;
            f(p, 1); f(p, 2); f(q, 3); f(P, 4); f(1, 1); f(nil, 1); f(void, 1); f(p, void);
            var q.extra = 1|; f(q, 1); f(P.new, 7);
            P.plus = function (a, b) { a - b }|; f(p, 1);
            p.setSlot("plus", function (a, b) { "own" })|; f(p, 1); p.removeLocalSlot("plus")|; f(p, 1);
            P.plus = function (a) { "one" }|; f(p, 1); P.plus = 3|; f(p, 2);
            P.plus = function { call.args.size }|; f(p, 1); P.plus = function (a, b) { b }|; f(p, 1);
            at (p.v > 10) echo("high") onleave echo("low"); f(p, 20); f(p, 1); f(q, 20);
            q.v = function () { "code" }|; f(q, 1); f(q, "s");
            p.setProperty("v", "constant", true)|; f(p, 1); p.setProperty("v", "constant", false)|; f(p, 1);
            class Other { function get() { "other" } }|; q.addProto(Other)|; f(q, 1);
            P.removeLocalSlot("get")|; f(p, 1); p.removeLocalSlot("v")|; f(p, 1);
            """),
        Map.entry(
            "variables of the lobby come, are watched, and go",
            """
            var g = 1|; var k = 2|;
            function h(n) { for| (var i : n) { g += k | k = k + 1 } | g }|;
            h(3); h(3); var more = 1|; h(2); at (g > 100) echo("on") onleave echo("off"); h(9); g = 1|;
            h(1); removeLocalSlot("k")|; h(1); var k = "s"|; h(1); k = 1|; g = "text"|; h(2); g = 0|;
            function k() { 5 }|; removeLocalSlot("k")|; function k() { 5 }|; h(1); h(1);
            getSlot("g").uid == g.uid; do (Object.new) { var g = 5; lobby.h(1) };
            function lobby.twice(f) { f() + f() }|; function r() { g = 3; return g + 1; 7 }|;
            twice(getSlotValue("r")); twice(closure () { g }); r() + r(); setProtos([Object])|; h(1); r();
            """),
        Map.entry(
            "functions that call each other pass everything on",
            """
            function same(a) { a }|; function void1(a) {}|; function first(a, b) { a }|;
            function keep(a) { a.setSlot("kept", true)|; a }|;
            function f(x) {
              var y = same(x); var z = keep(y); echo(x === y); echo(x.hasLocalSlot("kept")); echo(z === x);
              first(x = x + 1, x = x + 1) + first(x, x++)
            }|;
            f(1); f(2.5); f(3); same(void); same(); same(1, 2); void1(1); same(void1(2)); first(1, void1(3));
            function fact(n) { if (n <= 1) 1 else n * fact(n - 1) }|; fact(10); fact(20);
            function find(l, e) { for (var x : l) { if (x == e) return x }; "none" }|;
            function use(n) { find([1, 2, 3], n) }|; use(2); use(5); use(3);
            function deep(n) { if (n == 0) throw "deep" | deep(n - 1) + 1 }|;
            function guard(n) { try { deep(n) } catch (var e) { e + n } }|; guard(1); guard(3); deep(2);
            function scoped(n) { var t = Tag.new; t: { if (n > 1) { t.stop(n) }; n + 10 } }|;
            function outer(n) { scoped(n) + scoped(1) }|; outer(1); outer(2); outer(3);
            function sees(n) { var i = n; first(lazy(i += 1), i) }|; function lazy { call.evalArgAt(0) }|;
            sees(1); sees(2); function args(a, b = a + 1, c[]) { [a, b, c] }|;
            function some(n) { [args(n), args(n, 1), args(n, 1, 2, 3)] }|; some(1); some(2);
            function counter(n) { function () { n += 1 } }|; var c = counter(1)|; var d = counter(5)|;
            function both() { [c(), d(), c()] }|; both(); both(); both();
            """),
        Map.entry(
            "cases match, and bind their variables",
            """
            function byNumber(n) { switch (n) { case 0: 3; case 1: { n += 1; n }; case 2: return 7; default: n } }|;
            byNumber(0); byNumber(1); byNumber(2); byNumber(3); byNumber("s"); byNumber(nil); byNumber(void);
            function byForm(l) {
              var a = 1; var b = 2; var last = "none";
              switch (l) {
                case []: "empty"; case [1, var x]: last = x; case [var a1, a] if a1 > 2: a1 + b;
                case ("t", var y): y; case "text": "t"; case ["k" => var v]: v; case b: "b"
              };
              [a, b, last]
            }|;
            byForm([]); byForm([1, 5]); byForm([3, 1]); byForm(("t", 4)); byForm("text"); byForm(["k" => 8]);
            byForm(2); byForm([2, 1]); byForm([void]); byForm(nil);
            function inLoop(n) {
              var log = [];
              for (var i : n) { switch (i) { case 1: continue; case 3: break; case 0: log << "zero" }; log << i };
              for (var c : "abc") log << c; for (var k : ["x" => 1]) log << k; log
            }|;
            inLoop(2); inLoop(5); Float.'==' = function (o) { true }|; byNumber(5); inLoop(3);
            """),
        Map.entry(
            "lists have their elements and errors",
            """
            function f(l, i, v) {
              var old = l[i]; l[i] = v; l << old; l[i] += 1; l[-1]++;
              [l, l.size, old === l[-1], l[i] === v, [i, v, i += 1]]
            }|;
            f([1, 2, 3], 0, 5); f([1, 2, 3], -1, 5); f([1, 2], 2, 1); f([1], 0.5, 1); f([1], "s", 1);
            f(["k" => 1], "k", 2); f("text", 1, "x"); f(nil, 0, 1); f([1, 2], 1, void); f([[1]], 0, [2]);
            var watched = [1, 2]|; at (watched.size > 3) echo("long"); f(watched, 0, 4); f(watched, 1, 4);
            class Mine : List { function '[]'(i) { "mine" } }|; f(Mine.new, 0, 1); var own = [1, 2, 3]|;
            own.setSlot("size", 7)|; f(own, 0, 2); f([1, 2], 1, 2);
            List.size = function () { "many" }|; f([1, 2], 0, 2); f([1, 2], 0, 2);
            function each(l) { var sum = 0; for (var e : l) { l << e; sum += e; if (e == 3) return sum }; sum }|;
            each([1, 2]); each([3, 4]); each([]); each(["s"]); each([1, void]); each(3);
            function sum(l) { var s = 0; for| (var e : l) { s += e; e = 0 }; s }|; sum([1, 2]); sum([1, nil]); sum([1, 2]);
            """),
        Map.entry(
            "dictionaries have their entries and errors",
            """
            function f(d, k) { d[k] += 1; d[k]++; [d.has(k), d[k], d[k] === d[k], d.has("none"), d.get(k), d.size] }|;
            f(["a" => 1], "a"); f(["a" => 1], "b"); f([1 => 1], 1); f([1 => 1], 1.5); f([true => 1], true);
            f([nil => 2], nil); f([=>], void); f([1, 2], 1); f("text", 1); f(nil, 1); f([[1] => 1], [1]);
            class K { function '=='(o) { echo("==") | true }; function hash { echo("hash") | "k".hash } }|;
            f([K.new => 1], K.new); var watched = ["a" => 1]|; at (watched.has("b")) echo("b");
            function add(d, k) { d[k] = 1; d.has(k) }|; add(watched, "c"); add(watched, "b"); sleep(1ms)|;
            class Mine : Dictionary { function '[]'(k) { 7 }; function has(k) { "mine" } }|; f(Mine.new, "a");
            Dictionary.has = function (k) { "all" }|; f(["a" => 1], "a"); f(["a" => 1], "c");
            at (watched.size > 3) echo("many"); function size(d) { d.size }|; size(watched); add(watched, "d")|; sleep(1ms);
            Dictionary.size = function () { "some" }|; size(watched); size([1, 2]); size("abc"); size(nil);
            """),
        Map.entry(
            "what is not true is false",
            """
            function f(a) { var n = 0; if (!a) n = 1; while (!(n > 2 || !a)) n += 1; [!a, !!a, n, !(a == 1), (!a) === false] }|;
            f(true); f(false); f(0); f(1); f(2); f(""); f("a"); f(nil); f([]); f([=>]); f(void); f(Boolean); f(Object.new);
            class N { function '!'() { echo("!") | 7 } }|; f(N.new);
            var b = false|; at (!b) echo("not b"); b = true|; sleep(1ms); b = false|; sleep(1ms);
            function g(a) { if (!a) "no" else [!a, !(a == 1)] }|; g(true); g(false); g(1);
            Boolean.'!' = function () { "never" }|; g(true); g(false); g(1);
            """),
        Map.entry(
            "objects are equal as they say",
            """
            class E { var n = 1; function '=='(o) { echo("==") | true } }|; var e = E.new|; var o = Object.new|;
            function f(a, b) { if (a == b) echo("equal"); if (a != b) echo("different"); [a == b, b != a] }|;
            f(1, 1); f(1, nil); f(nil, 1); f(nil, nil); f("a", "a"); f("a", "b"); f("a", nil); f(o, o); f(o, nil);
            f(e, e); f(e, o); f(o, e); f([1], [1]); f([1], nil); f(true, true); f(Object, Object); f(f(o, o), 1);
            f(void, 1); f(1, void); f(o, void); f("a", void); f(o, 1 / 0); f(0 / 0, 0 / 0); f(f, f);
            Object.'==' = function (x) { "all" }|; f(o, nil); f(nil, nil); f("a", "a"); f(1, 1);
            """),
        Map.entry(
            "what is void is located",
            """
            function v() {};
            function a(o) { var y = v() && 1; y }; function b(o) { return o && v() || 3 };
            function c(o) { echo((v() || 1) + 2) }; function d(o) { o + (v() && 2) }; function e(o) { [1, v() && 2] };
            function f(o) { o == { while (v()) 1 } }; function g(o) { if (v() || o) 1 }; function h(o) { "a" != (v() && 2) };
            for (var o : ["a", 1, nil]) { for (var f : [a, b, c, d, e, f, g, h]) { try { f(o) } catch (var x) { echo(x) } } };
            a(1); b(1); c(1); d("a"); e(1); f("a"); f(1); g(1); h(1);
            """),
        Map.entry(
            "the size of something else is an error",
            """
            function size(l) { try { l.size } catch (var e) { e.message } }|;
            var l = [1, 2]|; size(l); size(l); l.protos = [List]|; size(l);
            List.updateSlot("size", Dictionary.getSlot("size"))|; size([1]); size([1]); size(["a" => 1]);
            String.updateSlot("size", List.getSlot("size"))|; for (var i : 4) echo(size("abc"));
            """),
        Map.entry(
            "a changed slot has the value that it takes",
            """
            class Global.P { var n = 1 }|; P.n->rangemin = 3|; class Q { var n = 5 }|; Q.n->updateHook = function (name, v) { v * 10 }|;
            function f(o) { var z = (o.n -= 1); [z, o.n, o.n += 2, o.n++, o.n] }|; f(P.new); f(P.new); f(Q.new); f(Q.new); f(P.new);
            var s = 1|; s->rangemax = 4|; function g(n) { var z = (s += n); [z, s] }|; g(9); g(1); g(-2); g(9);
            class R { var v = 0; get p { v }; set p(n) { v = n * 2 } }|;
            function h(o) { [o.p += 1, o.p, o.p = 4, o.p] }|; h(R.new); h(R.new); var t = s += 9; t;
            """),
        Map.entry(
            "variables of closures are shared",
            """
            function f(n) {
              var count = n; var add = function (x) { count += x; count++; count }; var name = closure () { this.n };
              [add(1), count, add(count), count = 5, add(2), count += 1, count--, count, add("s")]
            }|;
            f(1); f(2); f("s"); f(nil);
            function g(n) { const var c = n; var h = function () { c }; try { c = 2 } catch (var x) { echo(x.message) }; h() }|;
            g(1); g(2); function apply(h, a) { h(a) }|; apply(function (a) { a * 2 }, 4); apply(3, 4); apply(nil, 1);
            apply(function { call.args.size }, 1); apply(function (a, b) { a }, 1); apply(void, 1);
            { const var c = 5; for (var i : 30) { if (i == 29) c++ } };
            class N { var v = 1; function '+='(o) { echo("+= " + o) | this } }|;
            { const var c = N.new; for (var i : 30) { try { if (i == 29) c += 1 } catch (var e) { echo(e) } } };
            function k(n) { const var c = n * 2; switch (3) { case c++: 1; default: 2 } }|; k(1); k(2); k(3);
            function l(n) { const var c = n * 2; try { n + (c += 1) } catch (var e) { e } }|; l(1); l(2); l("s");
            function seen(n) { var x = 0; at (x > n) echo("x" + x); x = 1; x += 1; x++; sleep(1ms); x }|; seen(1); seen(0);
            """),
        Map.entry(
            "errors have their places",
            """
            function f(a, b) {
              if (a) a + b |
              var c = a < b |
              a += b; b = missing
            }|;
            function g(a, b) { while (f(a, b)) { 1 } }|;
            function h(n) { for (var i : n) { g(i, void) } }|;
            f(1, 2); f("x", 1); f(nil, 1); f(void, 1); f(1, nil); g(1, "s"); h(2); h(void); h("s");
            f(1, 2); f("x", 1); f(nil, 1); f(void, 1); f(1, nil); g(1, "s"); h(2); h(nil); h([1]);
            """));
  }
}
