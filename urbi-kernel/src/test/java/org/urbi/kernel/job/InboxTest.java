package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Semaphore;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;

/** The one way in. */
class InboxTest {
  private final Inbox inbox = new Inbox(Journal.NONE);
  private final ManualClock clock = ManualClock.real();
  private final List<Message> taken = new ArrayList<>();

  @Test
  void messagesAreTakenInTheOrderInWhichTheyCame() {
    int one = inbox.register(taken::add);
    int other = inbox.register(taken::add);
    List<Message> posted =
        List.of(
            new Message.ConsoleBytes(one, "a"),
            new Message.ConsoleBytes(other, "b"),
            new Message.InputEnded(one));
    posted.forEach(inbox::post);
    assertTrue(inbox.isFilled());
    inbox.take(clock, clock.now);
    assertEquals(posted, taken);
    assertFalse(inbox.isFilled());
  }

  @Test
  void whoIsForgottenHearsNothing() {
    int number = inbox.register(taken::add);
    inbox.post(new Message.InputEnded(number));
    inbox.forget(number);
    inbox.take(clock, clock.now);
    assertEquals(List.of(), taken);
  }

  @Test
  void numbersOfReceiversAreNeverUsedTwice() {
    int first = inbox.register(taken::add);
    inbox.forget(first);
    assertEquals(first + 1, inbox.register(taken::add));
    assertEquals(-1, inbox.reserve());
    assertEquals(-2, inbox.reserve());
  }

  @Test
  void anErrorOfOneReceiverIsToldAndKeepsNothingFromTheOthers() {
    List<Throwable> told = new ArrayList<>();
    inbox.setFailures((message, failure) -> told.add(failure));
    Error error = new StackOverflowError();
    int bad =
        inbox.register(message -> {
          throw error;
        });
    int good = inbox.register(taken::add);
    inbox.post(new Message.InputEnded(bad));
    inbox.post(new Message.InputEnded(good));
    inbox.take(clock, clock.now);
    assertEquals(List.of(error), told);
    assertEquals(List.of(new Message.InputEnded(good)), taken);
  }

  /** Otherwise a client would wait for ever for the answer to a question that nobody has read. */
  @Test
  void whatAClientSendsIsNotLostForWantOfMemoryAndKeepsItsOrder() {
    List<Throwable> told = new ArrayList<>();
    inbox.setFailures((message, failure) -> told.add(failure));
    int[] tries = {0};
    int wanting =
        inbox.register(message -> {
          if (tries[0]++ == 0) {
            throw new OutOfMemoryError();
          }
          taken.add(message);
        });
    int other = inbox.register(taken::add);
    List<Message> toWanting =
        List.of(
            new Message.ConsoleBytes(wanting, "a"),
            new Message.ConsoleBytes(wanting, "b"),
            new Message.InputEnded(wanting));
    toWanting.forEach(inbox::post);
    Message toOther = new Message.ConsoleBytes(other, "c");
    inbox.post(toOther);
    inbox.take(clock, clock.now);
    assertEquals(List.of(toOther), taken);
    assertTrue(inbox.isFilled(), "it waits for no other message");
    taken.clear();
    inbox.take(clock, clock.now);
    inbox.take(clock, clock.now);
    assertEquals(toWanting, taken);
    assertEquals(List.of(), told);
    assertFalse(inbox.isFilled());
  }

  @Test
  void clientWhoseInputNeverFitsIsToldSo() {
    List<Message> told = new ArrayList<>();
    inbox.setFailures((message, failure) -> told.add(message));
    int full =
        inbox.register(message -> {
          throw new OutOfMemoryError();
        });
    Message input = new Message.ConsoleBytes(full, "a");
    inbox.post(input);
    for (int tick = 0; tick < 100; tick++) {
      inbox.take(clock, clock.now);
    }
    assertEquals(List.of(input), told);
    assertFalse(inbox.isFilled());
  }

  /** Otherwise a client that was to be let go for its memory would keep it for ever. */
  @Test
  void whatEndsSomebodyIsNotLostForWantOfMemory() {
    List<Throwable> told = new ArrayList<>();
    inbox.setFailures((message, failure) -> told.add(failure));
    int[] tries = {0};
    int full =
        inbox.register(message -> {
          if (++tries[0] < 3) {
            throw new OutOfMemoryError();
          }
          taken.add(message);
        });
    inbox.post(new Message.ConnectionClosed(full));
    inbox.take(clock, clock.now);
    assertTrue(inbox.isFilled(), "it waits for no other message");
    inbox.take(clock, clock.now);
    assertEquals(List.of(), taken);
    inbox.take(clock, clock.now);
    assertEquals(List.of(new Message.ConnectionClosed(full)), taken);
    assertEquals(List.of(), told);
    assertFalse(inbox.isFilled());
  }

  @Test
  void aFloodLeavesTheJobsTheirTurn() {
    int number = inbox.reserve();
    inbox.register(
        number,
        message -> {
          taken.add(message);
          inbox.post(message);
        });
    inbox.post(new Message.InputEnded(number));
    inbox.take(clock, clock.now);
    assertEquals(1 << 16, taken.size());
    assertTrue(inbox.isFilled());
    inbox.take(clock, clock.now);
    assertEquals(2 << 16, taken.size());
  }

  /** Each message takes a millisecond: a crowd that connects must not make timers late. */
  @Test
  void aTickTakesMessagesForSomeTimeOnly() {
    int slow =
        inbox.register(message -> {
          taken.add(message);
          clock.now += 1_000_000;
        });
    for (int i = 0; i < 5; i++) {
      inbox.post(new Message.InputEnded(slow));
    }
    inbox.take(clock, clock.now);
    assertEquals(2, taken.size());
    assertTrue(inbox.isFilled(), "the rest is not forgotten");
    inbox.take(clock, clock.now);
    inbox.take(clock, clock.now);
    assertEquals(5, taken.size());
  }

  /** The tick itself has begun long ago, as when timers were late. */
  @Test
  void everyTickTakesAMessage() {
    int number = inbox.register(taken::add);
    inbox.post(new Message.InputEnded(number));
    clock.now += 100_000_000;
    inbox.take(clock, 0);
    assertEquals(1, taken.size());
  }

  /** What a run does must not depend on how fast the machine takes what is there. */
  @Test
  void inSimulatedTimeATickTakesAllMessages() {
    ManualClock simulated = ManualClock.simulated();
    int slow =
        inbox.register(message -> {
          taken.add(message);
          simulated.now += 1_000_000_000;
        });
    for (int i = 0; i < 5; i++) {
      inbox.post(new Message.InputEnded(slow));
    }
    inbox.take(simulated, 0);
    assertEquals(5, taken.size());
  }

  @Test
  void inAReplayNothingComesFromOutside() {
    Message recorded = new Message.InputEnded(Message.FIRST_FREE);
    Deque<Message> recording = new ArrayDeque<>(List.of(recorded));
    Inbox replayed =
        new Inbox(
            new Journal() {
              @Override
              public boolean isReplay() {
                return true;
              }

              @Override
              public Message next(Supplier<Message> inbox) {
                return recording.poll();
              }
            });
    replayed.register(taken::add);
    replayed.post(new Message.ConsoleBytes(Message.FIRST_FREE, "now"));
    assertFalse(replayed.isFilled());
    replayed.take(clock, clock.now);
    assertEquals(List.of(recorded), taken);
  }

  /** Nobody else would end the wait. */
  @Test
  void aMessageWakesWhoWaitsForOne() throws InterruptedException {
    Thread waiting = Thread.ofPlatform().start(() -> inbox.await(Long.MAX_VALUE));
    awaitParked(waiting);
    inbox.post(new Message.InputEnded(0));
    waiting.join();
  }

  @Test
  void whoHasAMessageDoesNotWait() {
    inbox.post(new Message.InputEnded(0));
    inbox.await(Long.MAX_VALUE);
    inbox.listen(Long.MAX_VALUE);
  }

  @Test
  void aWaitHasAnEnd() {
    inbox.await(1);
    inbox.listen(1);
  }

  private static void awaitParked(Thread thread) {
    while (thread.getState() != Thread.State.WAITING
        && thread.getState() != Thread.State.TIMED_WAITING) {
      Thread.onSpinWait();
    }
  }

  /** Tells what it is asked to do. */
  private static final class TestPoller implements KernelPoller {
    final List<String> asked = new CopyOnWriteArrayList<>();
    final Semaphore woken = new Semaphore(0);
    final CountDownLatch waits = new CountDownLatch(1);

    @Override
    public Wait begin(long nanoseconds) {
      asked.add("begin " + nanoseconds);
      return new Wait() {
        @Override
        public void await() {
          asked.add("await");
          waits.countDown();
          woken.acquireUninterruptibly();
        }

        @Override
        public void wake() {
          asked.add("wake");
          woken.release();
        }
      };
    }

    @Override
    public void poll() {
      asked.add("hear");
    }

    @Override
    public void pollIfDue(long now) {
      asked.add("glance " + now);
    }

    @Override
    public void close() {
      asked.add("close");
    }
  }

  @Test
  void whoListensElsewhereIsWokenThere() throws InterruptedException {
    TestPoller ear = new TestPoller();
    inbox.listenTo(ear);
    Thread listening = Thread.ofPlatform().start(() -> inbox.listen(17));
    ear.waits.await();
    inbox.post(new Message.InputEnded(0));
    listening.join();
    assertEquals(List.of("begin 17", "await", "wake", "hear"), ear.asked);
    inbox.post(new Message.InputEnded(0));
    assertEquals(4, ear.asked.size());
    inbox.listen(3);
    assertEquals(List.of("begin 3", "hear"), ear.asked.subList(4, 6));
  }

  @Test
  void whoIsBusyGlancesAndWhoEndsCloses() {
    TestPoller ear = new TestPoller();
    inbox.listenTo(ear);
    inbox.pollIfDue(5);
    inbox.close();
    assertEquals(List.of("glance 5", "close"), ear.asked);
  }
}
