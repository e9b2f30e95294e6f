package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A console client is asked to give back memory, perhaps when it does something else already. */
class ConsoleEvictionTest {
  private static final String WHY = "memory exhausted";

  private final Kernel kernel = Kernel.builder().log(line -> {}).start();
  private final StringBuffer output = new StringBuffer();
  private final LinkedBlockingQueue<String> marks = new LinkedBlockingQueue<>();
  private final CountDownLatch decided = new CountDownLatch(1);
  private final CountDownLatch told = new CountDownLatch(1);
  private KernelConnection client;

  @BeforeEach
  void connect() {
    kernel.define(
        "mark",
        arguments -> {
          marks.add((String) arguments.getFirst());
          return null;
        });
    kernel.define(
        "hold",
        nothing -> {
          marks.add("held");
          try {
            decided.await();
          } catch (InterruptedException e) {
            throw new AssertionError(e);
          }
          return null;
        });
    client =
        (KernelConnection)
            kernel.connect(
                new Client() {
                  @Override
                  public void output(String bytes) {
                    output.append(bytes);
                    if (bytes.contains(WHY)) {
                      told.countDown();
                    }
                  }

                  @Override
                  public void closed() {}
                });
  }

  @AfterEach
  void close() {
    decided.countDown();
    kernel.close();
  }

  private void await(String mark) throws InterruptedException {
    String next = marks.take();
    while (!next.equals(mark)) {
      next = marks.take();
    }
  }

  private void send(String statements) {
    client.send(statements + "\n");
  }

  /** The statement runs on, and is not told to have been interrupted. */
  @Test
  void theNextStatementGoesOn() throws InterruptedException {
    send("try { sleep(inf) } finally { mark(\"guilty\") }, mark(\"begun\");");
    await("begun");
    long last = client.lastStatement();
    send("hold | for| (3) 1 | sleep(1ms) | mark(\"alive\");");
    await("held");
    client.evict(last, WHY);
    decided.countDown();
    await("alive");
    told.await();
    assertFalse(output.toString().contains("interruption"), output.toString());
  }

  /** The end of what is guilty may come later than the rest of the next statement. */
  @Test
  void whatCameBeforeItEnds() throws InterruptedException {
    send("try { sleep(inf) } finally { mark(\"guilty\") }, mark(\"begun\");");
    await("begun");
    long last = client.lastStatement();
    send("hold | sleep(1ms);");
    await("held");
    client.evict(last, WHY);
    decided.countDown();
    await("guilty");
  }

  /** A statement in the background that has begun since is not to blame, either. */
  @Test
  void theNextStatementInTheBackgroundGoesOn() throws InterruptedException {
    send("mark(\"begun\");");
    await("begun");
    long last = client.lastStatement();
    send("{ mark(\"background\") | sleep(10ms) | mark(\"alive\") }, hold;");
    await("held");
    client.evict(last, WHY);
    decided.countDown();
    await("alive");
  }

  /** What runs when that is decided ends, with what waits behind it. */
  @Test
  void whatRunsIsEnded() throws InterruptedException {
    send("try { mark(\"begun\") | sleep(inf) } finally { mark(\"ended\") }; mark(\"dropped\");");
    await("begun");
    client.evict(WHY);
    await("ended");
    send("mark(\"over\");");
    assertEquals("over", marks.take());
  }

  /** Code that never lets others run. */
  @Test
  void whatHoldsTheKernelIsEnded() throws InterruptedException {
    send("mark(\"begun\") | while| (true) {};");
    await("begun");
    client.evict(WHY);
    send("mark(\"over\");");
    await("over");
    told.await();
  }
}
