package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.budget.Budget;

/**
 * What is to be done at a given time is done in the order of the deadlines, then of the requests.
 */
class TimersTest {
  private final Timers timers = new Timers(Budget::new);
  private final List<String> done = new ArrayList<>();

  private Timers.Timer at(long deadline, String name) {
    return timers.add(deadline, () -> done.add(name));
  }

  @Test
  void theFirstDeadlineComesFirst() {
    at(30, "c");
    at(10, "a");
    at(20, "b");
    assertEquals(10, timers.next());
    timers.fire(9);
    assertEquals(List.of(), done);
    timers.fire(10);
    assertEquals(List.of("a"), done);
    assertEquals(20, timers.next());
    timers.fire(100);
    assertEquals(List.of("a", "b", "c"), done);
    assertEquals(Long.MAX_VALUE, timers.next());
    timers.fire(Long.MAX_VALUE);
    assertEquals(3, done.size());
  }

  @Test
  void ofSimultaneousOnesTheFirstRequestComesFirst() {
    for (int i = 0; i < 20; i++) {
      at(10, "timer " + i);
    }
    timers.fire(10);
    for (int i = 0; i < 20; i++) {
      assertEquals("timer " + i, done.get(i));
    }
  }

  @Test
  void whatIsCancelledIsNotDoneAndWakesNobody() {
    Timers.Timer first = at(10, "a");
    at(20, "b");
    assertEquals(10, first.deadline());
    first.cancel();
    first.cancel();
    assertEquals(20, timers.next());
    timers.fire(30);
    assertEquals(List.of("b"), done);
    first.cancel();
  }

  @Test
  void whatIsAddedWhileOthersAreDoneHasItsTurnToo() {
    timers.add(
        10,
        () -> {
          done.add("a");
          at(10, "c");
          at(11, "d");
        });
    at(10, "b");
    timers.fire(10);
    assertEquals(List.of("a", "b", "c"), done);
    assertEquals(11, timers.next());
  }

  @Test
  void whatIsCancelledWhileOthersAreDoneIsNotDone() {
    Timers.Timer[] later = new Timers.Timer[1];
    timers.add(10, () -> later[0].cancel());
    later[0] = at(10, "never");
    timers.fire(10);
    assertEquals(List.of(), done);
  }

  @Test
  void aTimerThatIsMovedKeepsItsRank() {
    Timers.Timer first = at(10, "a");
    at(20, "b");
    first.cancel();
    timers.moved(first, 20, () -> done.add("moved"));
    timers.fire(20);
    assertEquals(List.of("moved", "b"), done);
  }

  /** Or a loop with a timeout would fill the memory. */
  @Test
  void cancelledOnesDoNotStayForEver() {
    at(1_000_000, "last");
    for (int i = 0; i < 20_000; i++) {
      at(500_000, "never").cancel();
    }
    assertEquals(1_000_000, timers.next());
    timers.fire(1_000_000);
    assertEquals(List.of("last"), done);
  }
}
