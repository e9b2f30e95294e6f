package org.urbi.kernel.node;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.kernel.Evaluator.numbers;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Evaluator;

/** Which clause of {@code try} runs, and when (manual, "Exceptions"). */
class TryTest {
  private final Evaluator code = new Evaluator();

  @AfterEach
  void close() {
    code.close();
  }

  @Test
  void theFirstClauseThatFitsRuns() {
    String tried =
        "function f(v) { try { throw v } catch (1) { \"one\" }"
            + " catch (var x if x == 2) { \"two\" } catch (var x) { [x] } }|; ";
    assertEquals(List.of("one", "two", numbers(3)), code.value(tried + "[f(1), f(2), f(3)]"));
  }

  @Test
  void whatNoClauseFitsGoesOn() {
    assertEquals(
        1.0, code.value("try { try { throw 1 } catch (2) { \"inner\" } } catch (var x) { x }"));
    assertEquals(
        1.0,
        code.value(
            "try { try { throw 1 } catch (var y if false) { \"inner\" } } catch (var x) { x }"));
    assertEquals(7.0, code.error("try { throw 7 } catch (2) {}").value());
  }

  @Test
  void elseRunsWhenNothingWasThrown() {
    assertEquals(3.0, code.value("try { 1 } catch (var e) { 2 } else { 3 }"));
    assertEquals(2.0, code.value("try { throw 1 } catch (var e) { 2 } else { 3 }"));
    assertEquals(
        1.0,
        code.value("function f() { try { return 1 } catch (var e) {} else { return 3 } }|; f()"));
    assertEquals(
        List.of("outer", 5.0),
        code.value(
            "try { try { 1 } catch (var e) { \"inner\" } else { throw 5 } }"
                + " catch (var x) { [\"outer\", x] }"));
  }

  @Test
  void finallyRunsHoweverTheBodyIsLeft() {
    assertEquals(1.0, code.value("try { 1 } finally { 2 }"));
    assertEquals(
        List.of(0.0, "end", "end", 2.0, "end"),
        code.value(
            "{ var seen = []; for (var i : 9) { try { if (i == 1) continue; if (i == 3) break;"
                + " seen << i } finally { if (i < 3) seen << \"end\" } }; seen }"));
    assertEquals(
        List.of(4.0, List.of("end")),
        code.value(
            "{ var seen = []; function f() { try { return 4 } finally { seen << \"end\" } };"
                + " var r = f(); [r, seen] }"));
    assertEquals(
        List.of("end", 5.0),
        code.value(
            "{ var seen = []; try { try { throw 5 } finally { seen << \"end\" } }"
                + " catch (var e) { seen << e }; seen }"));
  }

  @Test
  void finallyRunsWhenItsTagIsStopped() {
    assertEquals(
        List.of("begin", "end"),
        code.value(
            "{ var seen = []; var t = Tag.new;"
                + " { sleep(10ms) | t.stop }, t: try { seen << \"begin\"; sleep(1h) }"
                + " finally { seen << \"end\" }; seen }"));
  }

  @Test
  void whatFinallyThrowsCounts() {
    assertEquals(
        2.0, code.value("try { try { throw 1 } finally { throw 2 } } catch (var x) { x }"));
  }

  @Test
  void theExceptionOfTheClauseAroundIsBackBehindAnInnerOne() {
    assertEquals(
        1.0,
        code.value(
            "try { try { throw 1 } catch (var a) { try { throw 2 } catch (var b) {}; throw } }"
                + " catch (var c) { c }"));
  }

  @Test
  void anExhaustedStackIsAnExceptionWithItsPlace() {
    assertEquals(
        List.of("stack space exhausted", true),
        code.value(
            "function deep() { deep() + 1 }|;"
                + " try { deep() } catch (var e) { [e.message, e.isA(Exception.Scheduling)] }"));
    assertTrue(code.value("1 + 1").equals(2.0), "the kernel goes on");
  }
}
