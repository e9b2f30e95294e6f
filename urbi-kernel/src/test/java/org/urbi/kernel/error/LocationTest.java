package org.urbi.kernel.error;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/**
 * Errors tell where they are: the line, the columns, the calls that led there (manual, "Errors").
 */
class LocationTest {
  @Test
  void theLineAndTheColumnsAreThoseOfTheCall() {
    ConsoleTranscript.check(
        """
        missing;
        [00000000:error] !!! 1.1-7: lookup failed: missing
          missing;
        [00000000:error] !!! 2.3-9: lookup failed: missing

        1 + missing;
        [00000000:error] !!! 4.5-11: lookup failed: missing
        var x = missing;
        [00000000:error] !!! 5.9-15: lookup failed: missing
        echo(missing);
        [00000000:error] !!! 6.6-12: lookup failed: missing
        missing(1);
        [00000000:error] !!! 7.1-10: lookup failed: missing
        missing.foo;
        [00000000:error] !!! 8.1-7: lookup failed: missing
        Object.missing;
        [00000000:error] !!! 9.1-14: lookup failed: missing
        Object.missing(1, 2);
        [00000000:error] !!! 10.1-20: lookup failed: missing
        [1, missing, 3];
        [00000000:error] !!! 11.5-11: lookup failed: missing
        "a".missing.b;
        [00000000:error] !!! 12.1-11: lookup failed: missing
        """);
  }

  @Test
  void eachStatementOfALineHasItsColumns() {
    ConsoleTranscript.check(
        """
        1 / 0; 2 / 0; { 3 / 0 };
        [00000000:error] !!! 1.1-5: /: division by 0
        [00000000:error] !!! 1.8-12: /: division by 0
        [00000000:error] !!! 1.17-21: /: division by 0
        1 / 0 | 2;
        [00000000:error] !!! 2.1-5: /: division by 0
        1; missing; 2;
        [00000000] 1
        [00000000:error] !!! 3.4-10: lookup failed: missing
        [00000000] 2
        """);
  }

  @Test
  void aCallOverSeveralLinesBeginsAndEnds() {
    ConsoleTranscript.check(
        """
        Math.cos(1,
          2,
          3);
        [00000000:error] !!! 1.1-3.4: cos: expected 1 argument, given 3
        {
          1;
          2 /
            0
        };
        [00000000:error] !!! 6.3-7.5: /: division by 0
        """);
  }

  @Test
  void theCallsThatLedThereAreTold() {
    ConsoleTranscript.check(
        """
        function inner(x) { 1 / x }|;
        function outer(x)
        {
          inner(x);
        }|;
        outer(0);
        [00000000:error] !!! 1.21-25: /: division by 0
        [00000000:error] !!!    called from: 4.3-10: inner
        [00000000:error] !!!    called from: 6.1-8: outer
        class C { function m() { outer(0) } }|;
        C.new.m;
        [00000000:error] !!! 7.26-33: lookup failed: outer (possible misspelling of Mutex)
        [00000000:error] !!!    called from: 8.1-7: m
        [1, 0].map(function (x) { outer(x) });
        [00000000:error] !!! 9.27-34: lookup failed: outer (possible misspelling of Mutex)
        [00000000:error] !!!    called from: 9.1-37: map
        """);
  }

  @Test
  void whatOneThrowsIsWhereItIsThrown() {
    ConsoleTranscript.check(
        """
        function f()
        {
          throw Exception.new("mine")
        }|;
        f;
        [00000000:error] !!! 3.3-29: mine
        [00000000:error] !!!    called from: 5.1: f
        throw Exception.new("here");
        [00000000:error] !!! 6.1-27: here
        try { f } catch (var e) { e.location };
        [00000000] 3.3-29
        try { f } catch (var e) { e.backtrace };
        [00000000] [8.7: f]
        try { f } catch (var e) { throw };
        [00000000:error] !!! 3.3-29: mine
        [00000000:error] !!!    called from: 9.7: f
        try { f } catch (var e) { throw e };
        [00000000:error] !!! 3.3-29: mine
        """);
  }

  @Test
  void errorsOfSyntaxPointAtTheToken() {
    ConsoleTranscript.check(
        """
        1 + ;
        [00000000:error] !!! 1.5: syntax error: unexpected ;
        echo(1;
        if;
        var 1 = 2;
        "a
        b" + );
        [00000000:error] !!! 2.7: syntax error: unexpected ;
        [00000000:error] !!! 3.3: syntax error: unexpected ;
        [00000000:error] !!! 4.5: syntax error: 1 is not a valid lvalue
        [00000000:error] !!! 6.6: syntax error: unexpected )
        }
        echo("on");
        [00000000:error] !!! 7.1: syntax error: unexpected }
        """);
  }

  @Test
  void anErrorInTheBackgroundHasItsPlaceToo() {
    ConsoleTranscript.check(
        """
        {
          sleep(1s);
          missing
        },
        sleep(2s);
        [00001000:error] !!! 3.3-9: lookup failed: missing
        at (1 / 0) echo("never");
        [00002000:error] !!! 6.5-9: /: division by 0
        var e = Event.new|;
        at (e?)
          missing;
        e!;
        [00002000:error] !!! 9.3-9: lookup failed: missing
        sleep(1ms);
        """);
  }

  @Test
  void linesAreCountedInWhatIsLoaded() {
    ConsoleTranscript.check(
        """
        eval("1;\\n2 / 0;");
        [00000000:error] !!! 2.1-5: /: division by 0
        [00000000:error] !!!    called from: 1.1-18: eval
        eval("\\n\\nmissing");
        [00000000:error] !!! 3.1-7: lookup failed: missing
        [00000000:error] !!!    called from: 2.1-19: eval
        eval("1 +");
        [00000000:error] !!! 1.4: syntax error: unexpected end of file
        [00000000:error] !!!    called from: 3.1-11: eval
        """);
  }

  @Test
  void aNameAndALineMayBeGiven() {
    ConsoleTranscript.check(
        """
        //#push 10 "my.u"
        missing;
        [00000000:error] !!! my.u:10.1-7: lookup failed: missing

        missing;
        [00000000:error] !!! my.u:12.1-7: lookup failed: missing
        //#pop
        missing;
        [00000000:error] !!! 2.1-7: lookup failed: missing
        """);
  }

  @Test
  void slotsAndArgumentsAreToldWhereTheyAreUsed() {
    ConsoleTranscript.check(
        """
        var o = Object.new|;
        o.x = 1;
        [00000000:error] !!! 2.1-3: lookup failed: x
        var o.x = 1|;
        var o.x = 2;
        [00000000:error] !!! 4.7: slot redefinition: x
        o.x->constant = true|;
        o.x = 3;
        [00000000:error] !!! 6.1-3: cannot modify const slot
        o.missing += 1;
        [00000000:error] !!! 7.1-14: lookup failed: missing
        o.missing++;
        [00000000:error] !!! 8.1-11: lookup failed: missing
        function f(a, b) { a }|;
        f(1);
        [00000000:error] !!! 10.1-4: f: expected 2 arguments, given 1
        f(1,
          2, 3);
        [00000000:error] !!! 11.1-12.7: f: expected 2 arguments, given 3
        Math.cos("a");
        [00000000:error] !!! 13.1-13: cos: argument 1: unexpected "a", expected a Float
        "a" * "b";
        [00000000:error] !!! 14.1-9: *: argument 1: unexpected "b", expected a Float
        """);
  }

  @Test
  void theTextOfAnErrorIsThatOfItsType() {
    ConsoleTranscript.check(
        """
        try { missing } catch (var e) { [e.message, e.isA(Exception.Lookup)] };
        [00000000] ["lookup failed: missing", true]
        try { 1 / 0 } catch (var e) { [e.message, e.isA(Exception.Primitive)] };
        [00000000] ["division by 0", true]
        try { Math.cos } catch (var e) { [e.message, e.isA(Exception.Arity)] };
        [00000000] ["cos: expected 1 argument, given 0", true]
        try { eval("1 +") } catch (var e) { [e.message, e.isA(Exception.Syntax)] };
        [00000000] ["unexpected end of file", true]
        try { Global.setSlot("zz", 1); Global.setSlot("zz", 1) } catch (var e) { [e.message, e.isA(Exception.Redefinition)] };
        [00000000] ["slot redefinition: zz", true]
        try { echo(void) } catch (var e) { [e.message, e.isA(Exception.UnexpectedVoid)] };
        [00000000] ["unexpected void", true]
        try { nil: 1 } catch (var e) { [e.message, e.isA(Exception.Type)] };
        [00000000] ["unexpected nil, expected a Tag", true]
        """);
  }
}
