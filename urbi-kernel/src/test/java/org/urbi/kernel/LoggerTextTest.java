package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.trust.Role;

/**
 * What loggers write: texts of urbiscript are bytes, the log is read as text; and what clients try
 * on a bad day to make the log useless.
 */
class LoggerTextTest {
  /** More characters than the log takes of one client in a second, by far. */
  private static final String FLOOD = "for| (10000) Logger.log(\"x\" * 100)|;";

  private static final int OF_ONE = 1 << 14;
  private static final int OF_ALL = 1 << 15;

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final Kernel kernel =
      Kernel.builder().virtualTime(true).logLevel(LogLevel.LOG).log(log::add).start();

  @AfterEach
  void close() {
    kernel.close();
  }

  private TestClient observer() {
    return new TestClient(kernel, Role.OBSERVER);
  }

  private long size() {
    return log.stream().mapToLong(String::length).sum();
  }

  private List<String> containing(String text) {
    return log.stream().filter(line -> line.contains(text)).toList();
  }

  @Test
  void lettersOfAllLanguagesReachTheLog() {
    kernel.eval("Logger.new(\"Café\").log << \"température : 20°, 温度\"");
    kernel.eval("Logger.new(\"bytes\").log << \"\\xff\\xe9\"");
    String lines = String.join("\n", log);
    assertTrue(lines.contains("Café") && lines.contains("] température : 20°, 温度"), lines);
    assertTrue(lines.contains("] \u00ff\u00e9"), lines);
  }

  /** Code may end an indentation that it has not begun, or begin far too many. */
  @Test
  void indentationHasBounds() {
    kernel.eval("var l = Logger.new(\"l\")| l.onLeave| l.log << \"flat\"| l: { l.log << \"in\" }");
    kernel.eval("for| (100000) l.onEnter| l.log << \"deep\"");
    String lines = String.join("\n", log);
    assertTrue(lines.contains("] flat") && lines.contains("]   in"), lines);
    assertTrue(lines.contains("] " + "  ".repeat(32) + "deep"), lines);
  }

  @Test
  void indentationIsThatOfTheClient() {
    TestClient other = observer();
    assertEquals("", other.say("for| (100) Logger.onEnter;"));
    kernel.eval("Logger.log << \"mine\"");
    other.say("Logger.log(\"other\")|;");
    assertEquals(1, containing("] mine").size(), log.toString());
    assertEquals(1, containing("]   ").size(), log.toString());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Logger.log(\"x\\nurbi: memory exhausted\")|;",
        "Logger.log(\"x\\r\\nurbi: memory exhausted\")|;",
        "Logger.log(\"x\\rurbi: memory exhausted\")|;",
        "Logger.log(\"x\", \"c\\nurbi: memory exhausted\")|;",
        "Logger.log(\"x\", \"c\\rurbi: memory exhausted\")|;",
        "Logger.new(\"c\\nurbi: memory exhausted\").warn(\"x\")|;",
        "Logger.log(\"x\\xc2\\x85urbi: memory exhausted\")|;",
        "Logger.log(\"x\\xe2\\x80\\xa8urbi: memory exhausted\")|;",
        "Logger.log(\"x\\x0burbi: memory exhausted\")|;"
      })
  void noClientForgesALineOfTheServer(String code) {
    assertEquals("", observer().say(code));
    assertFalse(log.isEmpty());
    for (String message : log) {
      for (String line : message.split("\\R", -1)) {
        assertFalse(line.startsWith("urbi:"), message);
      }
    }
  }

  @Test
  void linesOfAMessageAreLinesOfTheLog() {
    kernel.eval("Logger.new(\"c\").log << \"one\\ntwo\"");
    kernel.eval("Logger.new(\"c\").log << \"\"");
    assertEquals(3, log.size());
    assertTrue(log.get(0).startsWith("[") && log.get(0).endsWith("] one"), log.toString());
    assertTrue(log.get(1).startsWith("[") && log.get(1).endsWith("] two"), log.toString());
    assertTrue(log.get(2).startsWith("[") && log.get(2).endsWith("] "), log.toString());
  }

  @Test
  void terminalOfTheAdministratorObeysNobody() {
    observer().say("Logger.log(\"\\x1b[2J\\x07\\xe2\\x80\\xae tab\\there\")|;");
    assertTrue(log.getFirst().endsWith("] \\x1b[2J\\x07\\u202e tab\there"), log.toString());
  }

  @Test
  void floodOfOneClientIsCutAndTold() {
    TestClient other = observer();
    assertEquals("", observer().say(FLOOD));
    long flood = size();
    assertTrue(flood <= OF_ONE + 200, "characters: " + flood);
    assertEquals(1, containing("logs too much").size(), log.toString());
    other.say("Logger.log(\"of another one\")|;");
    kernel.eval("Logger.log << \"of the program\"");
    assertEquals(1, containing("of another one").size());
    assertEquals(1, containing("of the program").size());
  }

  @Test
  void whoHasPausedIsHeardAgain() {
    TestClient client = observer();
    client.say(FLOOD + "sleep(2s);");
    client.say("Logger.log(\"again\")|;");
    assertEquals(1, containing("again").size());
  }

  /** Each new connection would begin with as much as it may log at once. */
  @Test
  void allClientsTogetherHaveALimitToo() {
    for (int i = 0; i < 20; i++) {
      TestClient client = observer();
      client.say(FLOOD);
      client.connection().close();
    }
    assertTrue(size() <= OF_ALL + 500, "characters: " + size());
    assertEquals(1, containing("clients log too much together").size(), log.toString());
    kernel.eval("Logger.log << \"of the program\"");
    assertEquals(1, containing("of the program").size());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Logger.log(\"x\" * 10000000)|;",
        "Logger.log(\"x\", \"c\" * 10000000)|;",
        "Logger.log(\"\\n\" * 10000000)|;",
        "Logger.log(\"\\n\" * 10000, \"c\" * 10000000)|;"
      })
  void hugeMessageIsCut(String code) {
    observer().say(code);
    assertTrue(size() <= OF_ONE + 200, "characters: " + size());
  }

  /** A program that logs much wants to. */
  @Test
  void theProgramItselfHasNoLimit() {
    kernel.eval("for| (10000) Logger.log << \"x\" * 100");
    assertEquals(10_000, log.size());
    kernel.eval("Logger.log << \"x\" * 1000000");
    assertTrue(log.getLast().length() > 1_000_000);
  }
}
