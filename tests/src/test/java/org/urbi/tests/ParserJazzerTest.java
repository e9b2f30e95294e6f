package org.urbi.tests;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.AfterAll;
import org.urbi.tests.KernelSession.BackEnd;
import org.urbi.tests.KernelSession.Console;

/**
 * The parser under a coverage-guided fuzzer: programs stand in a function that nobody calls, so
 * that they are read and, by and large, not run. One kernel serves many of them.
 */
class ParserJazzerTest {
  private static final int MAX_INPUT = 4_000;
  private static final int PROGRAMS_PER_KERNEL = 1_000;

  private static KernelSession session;
  private static int fed;

  @FuzzTest(maxDuration = "5m")
  void parserSurvives(byte[] bytes) throws Exception {
    String program = new String(bytes, StandardCharsets.ISO_8859_1);
    if (MAX_INPUT < program.length() || ConsoleFuzzTest.UNFIT.matcher(program).find()) {
      return;
    }
    if (fed++ % PROGRAMS_PER_KERNEL == 0) {
      close();
      session = KernelSession.inRealTime(BackEnd.BATON);
    }
    Console reader = session.connect();
    reader.send("function unread() {\n" + program + "\n}|;\n");
    reader.end();
    Console next = session.connect();
    next.send("1+1;\n");
    try {
      next.receives("] 2\n").get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
    } catch (TimeoutException e) {
      throw new AssertionError("no answer but:\n" + next.output(), e);
    }
    next.end();
  }

  @AfterAll
  static void close() {
    if (session != null) {
      session.close();
      session = null;
    }
  }
}
