package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.log.LogLevel;

/** What loggers write: texts of urbiscript are bytes, the log is read as text. */
class LoggerTextTest {
  @Test
  void lettersOfAllLanguagesReachTheLog() {
    List<String> log = new CopyOnWriteArrayList<>();
    try (Kernel kernel =
        Kernel.builder().virtualTime(true).logLevel(LogLevel.LOG).log(log::add).start()) {
      kernel.eval("Logger.new(\"Café\").log << \"température : 20°, 温度\"");
      kernel.eval("Logger.new(\"bytes\").log << \"\\xff\\xe9\"");
    }
    String lines = String.join("\n", log);
    assertTrue(lines.contains("Café") && lines.contains("] température : 20°, 温度"), lines);
    assertTrue(lines.contains("] \u00ff\u00e9"), lines);
  }

  /** Code may end an indentation that it has not begun, or begin far too many. */
  @Test
  void indentationHasBounds() {
    List<String> log = new CopyOnWriteArrayList<>();
    try (Kernel kernel =
        Kernel.builder().virtualTime(true).logLevel(LogLevel.LOG).log(log::add).start()) {
      kernel.eval(
          "var l = Logger.new(\"l\")| l.onLeave| l.log << \"flat\"| l: { l.log << \"in\" }");
      kernel.eval("for| (100000) l.onEnter| l.log << \"deep\"");
    }
    String lines = String.join("\n", log);
    assertTrue(lines.contains("] flat") && lines.contains("]   in"), lines);
    assertTrue(lines.contains("] " + "  ".repeat(32) + "deep"), lines);
  }
}
