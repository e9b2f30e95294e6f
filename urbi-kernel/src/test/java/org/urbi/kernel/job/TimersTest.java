package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
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

  /** Whatever is requested, moved and cancelled meanwhile: as if each had its place in one list. */
  @Test
  void rowsOfSimultaneousOnesKeepTheOrder() {
    record Request(long deadline, int number) {}
    var random = new Random(7);
    List<Request> expected = new ArrayList<>();
    List<Timers.Timer> requested = new ArrayList<>();
    for (int i = 0; i < 3000; i++) {
      // Rows of about ten; two thirds of the earlier ones are cancelled, some of them moved.
      long deadline = i / 10 % 7;
      requested.add(at(deadline, deadline + "." + i));
      expected.add(new Request(deadline, i));
      int other = random.nextInt(requested.size());
      if (random.nextInt(3) > 0 && expected.removeIf(request -> request.number == other)) {
        requested.get(other).cancel();
        if (random.nextInt(4) == 0) {
          long moved = random.nextInt(7);
          timers.moved(requested.get(other), moved, () -> done.add(moved + "." + other));
          expected.add(new Request(moved, -1 - other));
        }
      }
    }
    timers.fire(3);
    assertEquals(
        expected.stream().mapToLong(Request::deadline).filter(time -> time > 3).min().orElseThrow(),
        timers.next());
    timers.fire(6);
    assertEquals(
        expected.stream()
            .map(request ->
                new Request(request.deadline, Math.max(request.number, -1 - request.number)))
            .sorted(Comparator.comparing(Request::deadline).thenComparing(Request::number))
            .map(request -> request.deadline + "." + request.number)
            .toList(),
        done);
    assertEquals(Long.MAX_VALUE, timers.next());
  }

  /** They cost no look at the others of the queue, and give up their places one by one. */
  @Test
  void aRowIsCancelledFromEitherEnd() {
    List<Timers.Timer> row = new ArrayList<>();
    for (int i = 0; i < 200; i++) {
      row.add(at(10, "timer " + i));
    }
    for (int i = 0; i < 90; i++) {
      row.get(i).cancel();
      row.get(199 - i).cancel();
    }
    assertEquals(10, timers.next());
    at(10, "last");
    timers.fire(10);
    assertEquals("timer 90", done.getFirst());
    assertEquals(List.of("timer 109", "last"), done.subList(19, 21));
    assertEquals(21, done.size());
  }

  private final Budget crowd = new Budget();
  private final Budget other = new Budget();

  private void of(Budget budget, long deadline, String name) {
    timers.addUncounted(deadline, budget, () -> done.add(name));
  }

  /** What one tick does, in words: how many of the crowd, and everything else. */
  private String tick(long now) {
    done.clear();
    timers.fireSome(now);
    long many = done.stream().filter("crowd"::equals).count();
    return many + " " + done.stream().filter(name -> !name.equals("crowd")).toList();
  }

  /** It alone waits: 500 are done in their order, then each lobby has its part of as many. */
  @Test
  void aCrowdThatIsDueLetsOthersGoBefore() {
    for (int i = 0; i < 4 * Timers.MOST_IN_TICK; i++) {
      of(crowd, i % 7, "crowd");
    }
    of(crowd, 7, "last of the crowd");
    of(other, 8, "a");
    of(other, 9, "b");
    at(8, "of the machine");
    of(other, 12, "c");
    assertEquals("666 [a, b, of the machine]", tick(10));
    assertEquals(2, timers.next());
    of(other, 11, "d");
    assertEquals("750 [d]", tick(11));
    assertEquals("584 [last of the crowd, c]", tick(12));
    assertEquals(Long.MAX_VALUE, timers.next());
  }

  /** In however many ticks: each lobby has all of its own, in their order. */
  @Test
  void nothingIsLostBetweenTicks() {
    record Request(int lobby, long deadline, int number) {}
    var random = new Random(3);
    List<Budget> lobbies = Stream.generate(Budget::new).limit(5).toList();
    List<Request> ran = new ArrayList<>();
    List<Timers.Timer> requested = new ArrayList<>();
    Set<Request> expected = new HashSet<>();
    for (int i = 0; i < 5000; i++) {
      var request = new Request(i % 7 % 5, 100 + i / 4 % 50, i);
      expected.add(request);
      requested.add(
          timers.addUncounted(
              request.deadline,
              lobbies.get(request.lobby),
              () -> {
                ran.add(request);
                int number = 10_000 + request.number;
                if (random.nextInt(3) == 0) {
                  // In the same tick, before all that wait: from the earlier time of a slow job.
                  expected.add(new Request(request.lobby, 1, number));
                  timers.addUncounted(
                      1,
                      lobbies.get(request.lobby),
                      () -> ran.add(new Request(request.lobby, 1, number)));
                }
                int other = random.nextInt(requested.size());
                requested.get(other).cancel();
              }));
    }
    for (long now = 90; timers.next() < Long.MAX_VALUE; now += 10) {
      assertTrue(now < 1000, "never done");
      timers.fireSome(now);
    }
    assertEquals(ran.size(), new HashSet<>(ran).size());
    assertTrue(expected.containsAll(ran));
    for (int lobby = 0; lobby < 5; lobby++) {
      int of = lobby;
      List<Request> own =
          ran.stream().filter(request -> request.lobby == of && request.deadline > 1).toList();
      assertTrue(own.size() > 100);
      assertEquals(
          own.stream()
              .sorted(Comparator.comparing(Request::deadline).thenComparing(Request::number))
              .toList(),
          own);
    }
    // Whatever was requested in a tick, and could not be cancelled, was done.
    expected.removeIf(request -> request.deadline > 1);
    assertTrue(ran.containsAll(expected));
  }
}
