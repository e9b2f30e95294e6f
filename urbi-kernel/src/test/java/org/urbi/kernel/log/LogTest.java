package org.urbi.kernel.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Who gets the lines of a log, and how much of it is shown. */
class LogTest {
  private final List<String> log = new ArrayList<>();
  private final List<String> heard = new ArrayList<>();
  private final LogLines lines = new LogLines(log::add);

  @Test
  void listenersHearUntilTheyHaveHeardEnough() {
    lines.accept("before");
    Runnable enough = lines.listen(heard::add);
    lines.accept("meanwhile");
    enough.run();
    enough.run();
    lines.accept("after");
    assertEquals(List.of("before", "meanwhile", "after"), log);
    assertEquals(List.of("meanwhile"), heard);
  }

  /** One that leaves when it hears something, as a connection that is closed does. */
  @Test
  void listenerMayLeaveWhileItIsTold() {
    Runnable[] leave = new Runnable[1];
    leave[0] =
        lines.listen(line -> {
          heard.add("first " + line);
          leave[0].run();
        });
    lines.listen(line -> heard.add("second " + line));
    lines.accept("a");
    lines.accept("b");
    assertEquals(List.of("first a", "second a", "second b"), heard);
  }

  /** What the kernel itself tells has names in it that clients have chosen. */
  @Test
  void noMessageLooksLikeTwoOrIsObeyedByATerminal() {
    KernelLog kernelLog = new KernelLog(LogLevel.LOG, log::add);
    kernelLog.write("urbi: job a\nurbi: memory exhausted\r\u001b[2J\u0085\u2028\u202e");
    kernelLog.write("température :\t20°, 温度 \ud83e\udd16");
    assertEquals(
        List.of(
            "urbi: job a\n    urbi: memory exhausted\\x0d\\x1b[2J\\x85\\u2028\\u202e",
            "température :\t20°, 温度 \ud83e\udd16"),
        log);
  }

  @Test
  void levelsHaveNamesAndNumbers() {
    for (LogLevel each : LogLevel.values()) {
      assertSame(each, LogLevel.of(each.label()));
      assertSame(each, LogLevel.of(each.name()));
      assertSame(each, LogLevel.of(String.valueOf(each.ordinal())));
    }
    assertEquals("Debug", LogLevel.DEBUG.label());
    assertSame(LogLevel.LOG, LogLevel.of("everything"));
    assertSame(LogLevel.LOG, LogLevel.of(""));
  }
}
