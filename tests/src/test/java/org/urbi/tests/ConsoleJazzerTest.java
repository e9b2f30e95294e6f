package org.urbi.tests;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.urbi.tests.KernelSession.BackEnd;
import org.urbi.tests.KernelSession.Console;

/**
 * A console under a coverage-guided fuzzer. In a usual run it only gets what is in its input
 * folder; {@code mvn -Pfuzz test} goes on from there for as long as {@code -Dfuzz.duration} says.
 */
class ConsoleJazzerTest {
  private static final int MAX_INPUT = 4_000;

  @FuzzTest(maxDuration = "5m")
  void consoleSurvives(byte[] bytes) throws Exception {
    String program = new String(bytes, StandardCharsets.ISO_8859_1);
    if (MAX_INPUT < program.length() || ConsoleFuzzTest.UNFIT.matcher(program).find()) {
      return;
    }
    try (KernelSession session = KernelSession.inRealTime(BackEnd.BATON)) {
      Console victim = session.connect();
      victim.send(program);
      victim.end();
      Console next = session.connect();
      next.send("1+1;\n");
      answer(next);
    }
  }

  private static void answer(Console console) throws InterruptedException, ExecutionException {
    try {
      console.receives("] 2\n").get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
    } catch (TimeoutException e) {
      throw new AssertionError("no answer but:\n" + console.output(), e);
    }
  }
}
