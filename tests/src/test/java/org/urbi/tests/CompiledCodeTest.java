package org.urbi.tests;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.function.LongFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compiled code does what the interpreter does: values, identity, errors and backtraces. */
class CompiledCodeTest {
  private static final Duration GENERATED =
      Duration.ofSeconds(Integer.getInteger("urbi.tier.seconds", 30));

  private static final long FIRST_SEED = Long.getLong("urbi.tier.seed", 1);

  /**
   * @param threshold after how many calls or turns code is compiled
   * @param doubt every how many times compiled code takes the slow path in spite of itself
   */
  private record Mode(int threshold, int doubt) {}

  private static final List<Mode> MODES =
      List.of(new Mode(1, 0), new Mode(2, 0), new Mode(1, 3), new Mode(3, 2));

  /** For 10,000 nested calls, not 200,000: only programs about the stack need all of it. */
  static final int SMALL_STACK = 100;

  /** Runs a program, which must have no errors of syntax, in all modes. */
  static void compare(String name, int stack, String program) {
    String interpreted = KernelSession.runCompiled(0, 0, stack, program);
    assertFalse(interpreted.contains("syntax error"), name + ": " + interpreted);
    for (Mode mode : MODES) {
      String compiled = KernelSession.runCompiled(mode.threshold, mode.doubt, stack, program);
      if (!interpreted.equals(compiled)) {
        assertEquals(interpreted, compiled, name + " in " + mode + ":\n" + program);
      }
    }
  }

  /** Runs a program, which must have no errors of syntax, interpreted and in one mode. */
  static void compare(int threshold, int doubt, String program) {
    String interpreted = KernelSession.runCompiled(0, 0, 0, program);
    assertFalse(interpreted.contains("syntax error"), interpreted);
    assertEquals(interpreted, KernelSession.runCompiled(threshold, doubt, 0, program));
  }

  @Test
  void generatedProgramsDoTheSame() {
    compareGenerated(NumericProgramGenerator::program);
  }

  /** Runs programs of one seed after the other. */
  static void compareGenerated(LongFunction<String> generator) {
    long end = System.nanoTime() + GENERATED.toNanos();
    long seed = FIRST_SEED;
    do {
      compare("the program of seed " + seed, 0, generator.apply(seed));
      seed++;
    } while (System.nanoTime() < end);
  }

  @ParameterizedTest
  @MethodSource("names")
  void handMadeProgramsDoTheSame(String name) {
    int stack = name.contains("the stack is") ? 0 : SMALL_STACK;
    compare(name, stack, requireNonNull(HandMadePrograms.all().get(name)));
  }

  static Stream<String> names() {
    return HandMadePrograms.all().keySet().stream();
  }

  @Test
  void codeThatIsTooLongIsInterpreted() {
    String output =
        KernelSession.runCompiled(
            1,
            0,
            0,
            "function same(a) { a }|; function f(a) {\n"
                + "a = a + same(1);\n".repeat(300)
                + "a }|; f(0); System.tier[\"refused\"] > 0;");
    assertTrue(output.contains("] 300\n") && output.contains("] true\n"), output);
  }

  /** The JDK makes no room for slots that only such code has. */
  @Test
  void codeThatIsNeverReachedIsNoObstacle() {
    String output =
        KernelSession.runCompiled(
            1,
            0,
            0,
            """
            function f(x) { return x; var a = x + 1; var b = [a, f(a), x * 2]; b.size + a * x }|;
            f(7);
            System.tier["functions"];
            System.tier["refused"];
            """);
    assertTrue(
        output.contains("] 7\n") && output.contains("] 1\n") && output.contains("] 0\n"), output);
  }

  @Test
  void hotCodeIsCompiled() {
    String output =
        KernelSession.runCompiled(
            2,
            0,
            0,
            """
            function f(n) { var sum = 0; for| (var i : n) sum += i | sum }|;
            f(3); f(3); f(3);
            System.tier["functions"] > 0;
            System.tier["bytes"] > 0;
            """);
    assertTrue(output.contains("] true") && !output.contains("] false"), output);
  }
}
