package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Ending;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** The one way in, and the flag for those who cannot be reached by it. */
class InboxTest {
  private final Inbox inbox = new Inbox(Journal.NONE);
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
    inbox.take();
    assertEquals(posted, taken);
    assertFalse(inbox.isFilled());
  }

  @Test
  void whoIsForgottenHearsNothing() {
    int number = inbox.register(taken::add);
    inbox.post(new Message.InputEnded(number));
    inbox.forget(number);
    inbox.take();
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
    inbox.take();
    assertEquals(List.of(error), told);
    assertEquals(List.of(new Message.InputEnded(good)), taken);
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
    inbox.take();
    int once = taken.size();
    assertTrue(inbox.isFilled());
    inbox.take();
    assertEquals(2 * once, taken.size());
  }

  @Test
  void whoIsInterruptedIsSoOnce() {
    AtomicLong turn = new AtomicLong();
    Interruptions interruptions = new Interruptions(turn::get, Journal.NONE);
    UrbiObject lobby = new World().values().object.cloned();
    UrbiObject other = new World().values().object.cloned();
    assertFalse(interruptions.areWanted());
    interruptions.want(lobby);
    interruptions.want(other);
    assertTrue(interruptions.areWanted());
    assertEquals(Ending.WANTED, interruptions.decide(lobby));
    turn.incrementAndGet();
    assertEquals(Ending.NONE, interruptions.decide(lobby));
    assertTrue(interruptions.areWanted());
    interruptions.clear(other);
    assertFalse(interruptions.areWanted());
  }

  @Test
  void whatEndsHasAMomentToCleanUpAndNoMore() throws InterruptedException {
    AtomicLong turn = new AtomicLong(7);
    Interruptions interruptions = new Interruptions(turn::get, Journal.NONE);
    UrbiObject lobby = new World().values().object.cloned();
    interruptions.wantOverdue(7);
    assertEquals(Ending.OVERDUE, interruptions.decide(lobby));
    while (interruptions.decide(lobby) == Ending.NONE) {
      Thread.sleep(1);
    }
    assertEquals(Ending.OVERDUE, interruptions.decide(lobby));
    turn.incrementAndGet();
    assertEquals(Ending.NONE, interruptions.decide(lobby));
    assertFalse(interruptions.areWanted());
  }
}
