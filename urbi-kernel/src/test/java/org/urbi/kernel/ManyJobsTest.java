package org.urbi.kernel;

import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A client that starts jobs without end does not delay other clients. */
class ManyJobsTest {
  private final Kernel kernel = Kernel.builder().log(line -> {}).start();

  @AfterEach
  void close() {
    kernel.close();
  }

  private Connection client(String token, CountDownLatch told) {
    return kernel.connect(
        new Client() {
          @Override
          public void output(String bytes) {
            if (bytes.contains("*** " + token)) {
              told.countDown();
            }
          }

          @Override
          public void closed() {}
        });
  }

  /**
   * The number of jobs doubles with each tick: a client that had to wait for all of them would wait
   * for ever.
   */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "var e = Event.new; at (e?) { e! | e! }; e!;",
        "function h() { h() & h() }; h();",
        "function h() { detach(h()) | detach(h()) | sleep(1ms) }; h();",
      })
  void othersAreAnsweredWhileAndAfter(String program) throws Exception {
    CountDownLatch first = new CountDownLatch(1);
    CountDownLatch second = new CountDownLatch(1);
    CountDownLatch third = new CountDownLatch(1);
    CountDownLatch ticks = new CountDownLatch(20);
    Connection judge = client("first", first);
    client("tick", ticks).send("every (10ms) echo(\"tick\"),\n");
    Connection bomb = client("never", new CountDownLatch(1));
    bomb.send(program + "\n");
    judge.send("echo(\"first\");\n");
    first.await();
    ticks.await();
    client("second", second).send("echo(\"second\");\n");
    second.await();
    bomb.close();
    client("third", third).send("echo(\"third\");\n");
    third.await();
  }

  @Test
  void aTurnIsGivenToEachJobOfACrowd() throws Exception {
    CountDownLatch done = new CountDownLatch(1);
    client("100000", done).send("var n = 0|; for& (100000) { n++; n--; n++ }; echo(n);\n");
    done.await();
  }
}
