package org.urbi.kernel.lobby;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.job.JobThreads;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.World;
import org.urbi.kernel.time.VirtualClock;

/** What a lobby sends to its client. */
class OutputTest {
  private final List<String> sent = new ArrayList<>();
  private final List<Throwable> uncaught = new ArrayList<>();
  private final Scheduler scheduler =
      new Scheduler(
          new World(),
          new VirtualClock(),
          Journal.NONE,
          JobThreads.AUTO,
          (job, failure) -> uncaught.add(failure));

  /** How many times the client has no memory for it. */
  private int wanting;

  private final Output output = new Output(scheduler, this::take);

  private void take(String bytes) {
    if (wanting-- > 0) {
      throw new OutOfMemoryError();
    }
    sent.add(bytes);
  }

  private void run() throws InterruptedException {
    scheduler.time().whenQuiet(scheduler::stop);
    Thread loop = scheduler.startLoop(failure -> {});
    loop.join();
  }

  @Test
  void linesOfATickAreSentTogether() throws InterruptedException {
    output.send("", "one");
    output.send("error", "two");
    run();
    assertEquals(List.of("[00000000] one\n[00000000:error] two\n"), sent);
  }

  /** A client that waits for an answer would wait for ever. */
  @Test
  void whatIsToBeSentIsNotLostForWantOfMemory() throws InterruptedException {
    wanting = 3;
    output.write("one");
    output.write("two");
    run();
    assertEquals(List.of("onetwo"), sent);
    assertEquals(List.of(), uncaught);
  }

  @Test
  void muchOutputIsSentAtOnceOrIsStillToBeSent() throws InterruptedException {
    String much = "x".repeat(1 << 17);
    wanting = 1;
    assertThrows(OutOfMemoryError.class, () -> output.write(much));
    output.write("y");
    assertEquals(List.of(much + "y"), sent);
  }
}
