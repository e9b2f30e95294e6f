package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.kernel.trust.Role;

/** A statement of a megabyte is read and compiled in many turns, between which others run. */
class LongStatementTest {
  private static final String FUNCTION =
      "function f() { " + "var x = 1; x += 2; ".repeat(50_000) + "};";

  private final Kernel kernel =
      Kernel.builder().virtualTime(true).output(text -> {}).log(line -> {}).start();

  private final TestClient client = new TestClient(kernel, Role.OWNER);

  @AfterEach
  void close() {
    kernel.close();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '@',
      quoteCharacter = '`',
      value = {
        "{ @ 1; @ 1 };",
        "{ @ 1; @ ) };",
        "var l = [ @ 1, @ 1 ] |;",
        "1 @ + 1 @ ;",
        "function f() { @ var x = 1; x += 2; @ };",
        "function f() { @ var x = 1; function () { x }; @ };",
      })
  void othersRunMeanwhile(String begin, String repeated, String end) {
    client.say("var Global.turns = 0|; detach({ loop { turns++ } })|;");
    String answer =
        client.say(
            "var before = turns|;\n"
                + begin
                + repeated.repeat(500_000 / repeated.length())
                + end
                + "\necho(\"turns: %s\" % (turns - before));");
    int turns = Integer.parseInt(answer.substring(answer.indexOf("turns: ") + 7).strip());
    assertTrue(turns > 100, answer);
  }

  @Test
  void whoInterruptsItDropsIt() throws InterruptedException {
    CountDownLatch interrupted = new CountDownLatch(1);
    kernel.define(
        "interrupt",
        nothing -> {
          client.connection().interrupt();
          interrupted.countDown();
          return null;
        });
    client
        .connection()
        .send("detach({ for (20) {}; interrupt })|;\n" + FUNCTION + "echo(\"executed\");\n");
    interrupted.await();
    assertEquals("*** f is unknown", client.say("try { f } catch { echo(\"f is unknown\") };"));
  }
}
