package org.urbi.kernel.embed;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.JobThreads;

/** Evaluation, calls, values and errors, seen from one thread. */
@ParameterizedClass
@EnumSource(names = {"TICK_LOOP", "BATON"})
class EmbeddingTest {
  private final JobThreads jobThreads;
  private final StringBuffer output = new StringBuffer();
  private Kernel kernel;

  EmbeddingTest(JobThreads jobThreads) {
    this.jobThreads = jobThreads;
  }

  @BeforeEach
  void start() {
    kernel =
        Kernel.builder().virtualTime(true).jobThreads(jobThreads).output(output::append).start();
  }

  @AfterEach
  void stop() {
    kernel.close();
  }

  @Test
  void valuesComeBackAsJavaValues() {
    assertEquals(3.0, kernel.eval("1 + 2"));
    assertEquals(true, kernel.eval("1 < 2;"));
    assertEquals("ab", kernel.eval("\"a\" + \"b\""));
    assertEquals(List.of(1.0, List.of("x")), kernel.eval("[1, [\"x\"]]"));
    assertEquals(List.of(1.0, 2.0), kernel.eval("(1, 2)"));
    assertEquals(Map.of("a", 1.0), kernel.eval("[\"a\" => 1]"));
    assertEquals(Arrays.asList(null, true), kernel.eval("[nil, true]"));
    assertNull(kernel.eval("nil"));
    assertNull(kernel.eval("{}"));
    assertNull(kernel.eval(""));
  }

  @Test
  void theLastStatementCountsAndDefinitionsStay() {
    assertEquals(5.0, kernel.eval("var x = 2; x = x + 3; x"));
    assertEquals(5.0, kernel.eval("x"));
    kernel.eval("x = 6");
    assertEquals(6.0, kernel.eval("x"));
    assertThrows(UrbiError.class, () -> kernel.eval("var x = 7"));
  }

  @Test
  void stringsAreUtf8OnTheOtherSide() {
    assertEquals("Grüße, 世界 🤖", kernel.eval("\"Grüße, 世界 🤖\""));
    assertEquals(2.0, kernel.eval("\"ü\".size"));
    assertEquals("ü", kernel.call("String.new", "ü"));
    // Not UTF-8: one character for each byte.
    assertEquals("\u00fc", kernel.eval("\"\\xfc\""));
    assertArrayEquals(new byte[] {(byte) 0xfc, 0}, kernel.eval("\"\\xfc\\0\"", byte[].class));
    assertEquals(2.0, ((UrbiValue) kernel.eval("function(s) { s.size }")).apply(new byte[2]));
    kernel.eval("echo(\"ü\")");
    assertEquals("[00000000] *** ü\n", output.toString());
  }

  @Test
  void valuesAreConvertedToTheTypeWanted() {
    int answer = kernel.eval("42", int.class);
    assertEquals(42, answer);
    assertEquals(42L, kernel.eval("42", Long.class));
    assertEquals(Duration.ofMillis(1500), kernel.eval("1.5s", Duration.class));
    assertArrayEquals(new double[] {1, 2}, kernel.eval("[1, 2]", double[].class));
    assertEquals('x', kernel.eval("\"x\"", char.class));
    assertNull(kernel.eval("nil", String.class));
    assertEquals(3.0, kernel.eval("[1, 2, 3]", UrbiValue.class).call("size"));
    assertThrows(ClassCastException.class, () -> kernel.eval("1.5", int.class));
    assertThrows(ClassCastException.class, () -> kernel.eval("1e12", int.class));
    assertThrows(ClassCastException.class, () -> kernel.eval("nil", int.class));
    assertThrows(ClassCastException.class, () -> kernel.eval("\"1\"", Double.class));
    assertThrows(ClassCastException.class, () -> kernel.eval("[\"1\"]", int[].class));
  }

  @Test
  void javaValuesAreArguments() {
    kernel.eval("function id(x) { x }; function kind(x) { x.type }");
    Object value = Arrays.asList(1.0, "two", false, null, Map.of("k", List.of()));
    assertEquals(value, kernel.call("id", value));
    assertEquals(List.of(1.0, 2.0), kernel.call("id", new int[] {1, 2}));
    assertEquals(List.of("c", 7.0), kernel.call("id", (Object) new Object[] {'c', (byte) 7}));
    assertEquals("Duration", kernel.call("kind", Duration.ofSeconds(2)));
    assertEquals(2.5, kernel.call("id", Duration.ofMillis(2500)));
    assertThrows(IllegalArgumentException.class, () -> kernel.call("id", new Object()));
    List<Object> own = new ArrayList<>();
    own.add(own);
    assertThrows(IllegalArgumentException.class, () -> kernel.call("id", own));
  }

  @Test
  void containersInThemselvesStayHandles() {
    List<?> list = kernel.eval("var l = [1]; l << l << l; l", List.class);
    assertEquals(1.0, list.getFirst());
    assertInstanceOf(UrbiValue.class, list.get(1));
    kernel.eval("var deep = []; for (1000) deep = [deep, deep]");
    assertInstanceOf(List.class, kernel.eval("deep"));
  }

  @Test
  void functionsAreCalledByNameOrPath() {
    kernel.eval("function twice(x) { 2 * x }; class A { function f(y, z) { [y, z] } }");
    assertEquals(42.0, kernel.call("twice", 21));
    assertEquals(List.of("y", 3.0), kernel.call("A.f", "y", 3));
    UrbiError missing = assertThrows(UrbiError.class, () -> kernel.call("A.g"));
    assertEquals("lookup failed: g", missing.getMessage());
    UrbiError arity = assertThrows(UrbiError.class, () -> kernel.call("twice"));
    assertEquals("twice: expected 1 argument, given 0", arity.getMessage());
  }

  @Test
  void objectsAreHandles() {
    UrbiValue object = (UrbiValue) kernel.eval("class P { var x = 1; function f(d) { x + d } }");
    assertEquals(1.0, object.get("x"));
    object.set("x", 5);
    object.set("y", List.of("new"));
    assertEquals(7.0, object.call("f", 2));
    assertEquals(List.of("new"), kernel.eval("P.y"));
    assertTrue(object.has("y"));
    object.remove("y");
    assertFalse(object.has("y"));
    assertEquals(object, kernel.eval("P"));
    assertNotEquals(object, kernel.eval("Object.new"));
    assertEquals("P", object.toString());
    assertEquals(true, ((UrbiValue) kernel.eval("function(a) { a === P }")).apply(object));
    assertInstanceOf(UrbiValue.class, object.get("f"));
    try (Kernel other = Kernel.builder().jobThreads(jobThreads).start()) {
      assertThrows(IllegalArgumentException.class, () -> other.call("echo", object));
    }
  }

  @Test
  void errorsAreExceptions() {
    UrbiError lookup = assertThrows(UrbiError.class, () -> kernel.eval("1;\n  foo"));
    assertEquals("2.3-5: lookup failed: foo (possible misspelling of log)", lookup.getMessage());
    assertEquals(2, lookup.location().line());
    assertEquals("foo", ((UrbiValue) lookup.value()).get("name"));

    kernel.eval("function f() { g() }; function g() { throw 42 }");
    UrbiError thrown = assertThrows(UrbiError.class, () -> kernel.eval("f()"));
    assertEquals(42.0, thrown.value());
    assertEquals(List.of("g", "f"), thrown.backtrace().stream().map(c -> c.name()).toList());
    assertTrue(thrown.report().contains("\n!!!    called from: 1.1-3: f"), thrown.report());
    assertEquals("urbiscript", thrown.getStackTrace()[0].getClassName());
    assertTrue(
        Arrays.stream(thrown.getStackTrace())
            .anyMatch(e -> e.getMethodName().equals("errorsAreExceptions")),
        "the trace ends in the calling thread");

    UrbiError syntax = assertThrows(UrbiError.class, () -> kernel.eval("var y = 1;\n1 +"));
    assertTrue(syntax.getMessage().contains("syntax error"), syntax.getMessage());
    assertEquals(2, syntax.location().line());
    assertThrows(UrbiError.class, () -> kernel.eval("y"), "nothing of it was executed");
  }

  @Test
  void errorsHaveHints() {
    assertEquals(Optional.of("a double quote ends it"), hint("var s = \"abc"));
    assertEquals(
        Optional.of(
            "the first has the index 0, the last of a list -1; list << value makes it longer"),
        hint("[1, 2][2]"));
    assertEquals(Optional.of("a recursion does not end"), hint("function f() { f() }; f()"));
    assertEquals(Optional.empty(), hint("throw 42"));
    assertEquals(Optional.empty(), hint("nameOfNothing"));
  }

  /** Before much is compiled the stack of Java may end first, and memory may before both. */
  @Test
  void errorsOfTheMachineHaveTheSameHints() {
    UrbiError stack = UrbiErrorConverter.of(null, null, new StackOverflowError());
    assertEquals(Problem.STACK_EXHAUSTED.text(), stack.getMessage());
    assertEquals(Problem.STACK_EXHAUSTED.hint(), stack.hint());
    UrbiError memory = UrbiErrorConverter.of(null, null, new OutOfMemoryError());
    assertEquals(Problem.MEMORY_EXHAUSTED.text(), memory.getMessage());
    assertEquals(Problem.MEMORY_EXHAUSTED.hint(), memory.hint());
  }

  private Optional<String> hint(String code) {
    return assertThrows(UrbiError.class, () -> kernel.eval(code)).hint();
  }

  @Test
  void runawayRecursionIsAnError() {
    kernel.eval("function down(n) { down(n + 1) + 1 }");
    UrbiError error = assertThrows(UrbiError.class, () -> kernel.call("down", 0));
    assertTrue(error.getMessage().contains("stack space exhausted"), error.getMessage());
    assertEquals(3.0, kernel.eval("1 + 2"));
  }

  @Test
  void hugeResultsAreJustThat() {
    List<?> numbers = kernel.eval("var l = []; for| (var i : 200000) l << i; l", List.class);
    assertEquals(200_000, numbers.size());
    assertEquals(199_999.0, numbers.getLast());
    assertEquals(1 << 20, kernel.eval("\"x\" * (2 ** 20)", String.class).length());
    List<Integer> sent = IntStream.range(0, 200_000).boxed().toList();
    kernel.eval("function size(list) { list.size }");
    assertEquals(200_000.0, kernel.call("size", sent));
  }

  @Test
  void javaFunctionsAreCalledFromEverywhere() {
    kernel.define("sum", all -> all.stream().mapToDouble(v -> (Double) v).sum());
    assertEquals(6.0, kernel.eval("sum(1, 2, 3)"));
    assertEquals(3.0, kernel.eval("class C { function f() { sum(1, 2) } }; C.f"));
    kernel.define("C.name", all -> "C" + all);
    assertEquals("C[1.0]", kernel.eval("C.name(1)"));
    kernel.define("sum", all -> null);
    assertNull(kernel.eval("sum(1)"));
  }

  @Test
  void whatAJavaFunctionThrowsIsAnUrbiscriptException() {
    kernel.define(
        "fail",
        all -> {
          throw new IllegalStateException("não");
        });
    assertEquals("1.7-10: fail: não", kernel.eval("try { fail } catch (var e) { e.asString }"));
    UrbiError error = assertThrows(UrbiError.class, () -> kernel.eval("fail"));
    assertTrue(error.getMessage().endsWith("fail: não"), error.getMessage());
    kernel.define("cast", all -> new Object());
    assertThrows(UrbiError.class, () -> kernel.eval("cast"));
  }

  @Test
  void javaFunctionsUseHandlesButDoNotEvaluate() {
    kernel.define("twice", all -> List.of(apply(all), apply(all)));
    kernel.eval("var n = 0; function count() { n = n + 1 | sleep(1s) | n }");
    assertEquals(List.of(1.0, 2.0), kernel.eval("twice(&count)"));
    kernel.eval("function bad() { throw \"bad\" }");
    assertEquals("bad", kernel.eval("try { twice(&bad) } catch (var e) { e }"));

    kernel.define("again", all -> kernel.eval("1"));
    UrbiError error = assertThrows(UrbiError.class, () -> kernel.eval("again"));
    assertTrue(error.getMessage().contains("the kernel thread cannot wait"), error.getMessage());
    kernel.define("wait", all -> kernel.awaitTermination());
    assertThrows(UrbiError.class, () -> kernel.eval("wait"));
    kernel.define("later", all -> kernel.evalAsync("var done = 1").isDone());
    assertEquals(false, kernel.eval("later"));
    assertEquals(1.0, kernel.eval("sleep(1s) | done"));
  }

  private static Object apply(List<Object> arguments) {
    return ((UrbiValue) arguments.getFirst()).apply();
  }

  @Test
  void outputComesBeforeTheResult() {
    kernel.eval("echo(1) | sleep(1s) | echo(2)");
    assertEquals("[00000000] *** 1\n[00001000] *** 2\n", output.toString());
    kernel.eval("foo,");
    kernel.eval("sleep(1s)");
    assertTrue(output.toString().contains("[00001000:error] !!! 1.1-3: lookup failed: foo "));
  }

  @Test
  void simulatedTimePassesWhileSomebodyWaits() {
    kernel.eval("var ticks = 0; every (1s) { ticks = ticks + 1 },");
    for (int i = 0; i < 3; i++) {
      assertEquals(kernel.eval("ticks"), kernel.eval("ticks"));
    }
    kernel.eval("sleep(9500ms)");
    assertEquals(10.0, kernel.eval("ticks"));
    kernel.evalAsync("sleep(1s) | echo(ticks) | shutdown(7)");
    assertEquals(7, kernel.awaitTermination());
    assertEquals("[00010500] *** 11\n", output.toString());
  }

  @Test
  void anEvaluationCanBeStopped() {
    assertNull(kernel.eval("var t = Tag.new; t: { t.stop; 1 }"));
    var asleep = kernel.evalAsync("sleep");
    assertEquals(
        "the evaluation was stopped",
        assertThrows(CancellationException.class, () -> kernel.eval("quit")).getMessage());
    assertThrows(CancellationException.class, asleep::join);
    assertEquals(2.0, kernel.eval("1 + 1"));
  }
}
