package org.urbi.kernel;

import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Code that never lets others run ends when its client interrupts it, or leaves. */
class InterruptionTest {
  private final Kernel kernel = Kernel.builder().log(line -> {}).start();

  /** Called by urbiscript when the code that holds the kernel is about to begin. */
  private final CountDownLatch begun = new CountDownLatch(1);

  @AfterEach
  void close() {
    kernel.close();
  }

  /** A client that counts down when it is answered "alive". */
  private Connection client(CountDownLatch alive) {
    return client(alive, "");
  }

  private Connection client(CountDownLatch alive, String budget) {
    return kernel.connect(
        new Client() {
          @Override
          public String budget() {
            return budget;
          }

          @Override
          public void output(String bytes) {
            if (bytes.contains("alive")) {
              alive.countDown();
            }
          }

          @Override
          public void closed() {}
        });
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "function f(n) { if (n < 2) n else f(n - 1) + f(n - 2) }; begun; f(60);",
        "function f(n) { if (n < 2) n else f(n - 1) | f(n - 2) }; begun; try { f(60) } catch {};",
        "begun; while| (true) {};",
        "begun; loop| 1;",
        "begun; for| (var i: 100000000) i;",
        "begun; for| (var i = 0; true; i++) i;",
        "begun; 100000000.'each|'(function (i) { i });",
        "var l = [1]; for| (40) l = [l, l]; begun; l.hash;",
        "var l = [1]; for| (40) l = [l, l]; begun; l == l.asList + [];",
        "var l = [1]; for| (40) l = [l, l]; begun; l.asString;",
        "function z() { try { z } catch { z } }; begun; z;",
        "function z() { try { z } finally { z } }; begun; z;",
        "var o = Object.new; begun; for| (200000) o = o.new; o.nowhere;",
        "var e = Event.new; at sync (e?) { e! | e! }; begun; e!;",
        "begun; Regexp.new(\"^(a|a)*(a|a)*b$\").match(\"a\" * 40);",
        "var l = []; for| (var i: 300000) l << i.sin; begun; loop| l.sort;",
        "var l = []; for| (100000) l << \"zzz\"; begun; (\"ab\" * 1000000).split(l);",
        // Texts of values and of exceptions that nobody has caught.
        "var o = Object.new; function o.asString() { begun; loop| 1 }; o;",
        "var o = Object.new; function o.asString() { begun; loop| 1 }; throw o;",
        "var o = Object.new; function o.asString() { begun; loop sleep(10ms) }; o;",
        "var o = Object.new; function o.asString() { begun; loop sleep(10ms) }; throw o;",
        "var o = Object.new; function o.asString() { begun; loop| 1 }; {throw o},",
      })
  void theInterruptKeyEndsWhateverRuns(String program) throws Exception {
    interrupts(program, "");
  }

  /** To tell what is wrong with a statement runs code, too, before the statement does. */
  @Test
  void theInterruptKeyEndsTheTextOfWhatEndedTheReader() throws Exception {
    interrupts(
        "Exception.asString = function () { begun; loop| 1 };\n1" + "&1".repeat(500_000) + ";",
        "memory=1M");
  }

  private void interrupts(String program, String budget) throws Exception {
    kernel.define(
        "begun",
        nothing -> {
          begun.countDown();
          return null;
        });
    CountDownLatch judged = new CountDownLatch(1);
    CountDownLatch answered = new CountDownLatch(1);
    Connection judge = client(judged);
    Connection busy = client(answered, budget);
    busy.send(program + "\n");
    begun.await();
    judge.send("echo(\"alive\");\n");
    busy.interrupt();
    judged.await();
    busy.send("echo(\"alive\");\n");
    answered.await();
  }

  @Test
  void whatRunsEndsWhenItsClientLeaves() throws Exception {
    kernel.define(
        "begun",
        nothing -> {
          begun.countDown();
          return null;
        });
    CountDownLatch judged = new CountDownLatch(1);
    Connection judge = client(judged);
    Connection busy = client(new CountDownLatch(1));
    busy.send("function f(n) { if (n < 2) n else f(n - 1) + f(n - 2) }; begun; f(60);\n");
    begun.await();
    judge.send("echo(\"alive\");\n");
    busy.close();
    judged.await();
  }
}
