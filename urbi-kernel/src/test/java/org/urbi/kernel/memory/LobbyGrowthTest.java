package org.urbi.kernel.memory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.budget.Budget;

/** Who has to give back memory first. */
class LobbyGrowthTest {
  private static final long MEGABYTE = 1 << 20;
  private static final int SECONDS = 4;

  private final Map<Budget, Long> allocated = new HashMap<>();
  private final List<Evictable> clients = new ArrayList<>();

  /** In nanoseconds. */
  private long now = 1_000_000_000_000L;

  private final LobbyGrowth growth =
      new LobbyGrowth(budget -> allocated.getOrDefault(budget, 0L), clients, () -> now);

  private final class Client implements Evictable {
    private final Budget budget = new Budget();

    Client() {
      clients.add(this);
    }

    void allocate(long bytes) {
      allocated.merge(budget, bytes, Long::sum);
    }

    @Override
    public Budget budget() {
      return budget;
    }

    @Override
    public String description() {
      return "a client";
    }

    @Override
    public void evict(String why) {}

    @Override
    public boolean isAtWork() {
      return false;
    }

    @Override
    public boolean stays() {
      return false;
    }

    @Override
    public void close() {}
  }

  private void measure(int times, boolean scarce) {
    for (int i = 0; i < times; i++) {
      growth.measure(scarce);
    }
  }

  @Test
  void largestGrowthGoesFirstAndOnlyOnce() {
    Client small = new Client();
    Client large = new Client();
    small.allocate(MEGABYTE);
    large.allocate(2 * MEGABYTE);
    measure(1, true);
    assertEquals(2.0 * MEGABYTE, growth.largest());
    assertSame(large, growth.next());
    growth.evicted(large);
    assertSame(small, growth.next());
    growth.evicted(small);
    assertNull(growth.next());
    growth.forget();
    assertSame(large, growth.next());
  }

  /** All of it may come between two looks at the memory. */
  @Test
  void whatWasAllocatedJustBeforeMemoryWasScarceCounts() {
    Client hog = new Client();
    Client other = new Client();
    measure(60 * SECONDS, false);
    hog.allocate(32 * MEGABYTE);
    other.allocate(MEGABYTE);
    measure(1, true);
    assertSame(hog, growth.next());
  }

  @Test
  void whatWasAllocatedLongAgoWeighsLittle() {
    Client once = new Client();
    once.allocate(1000 * MEGABYTE);
    measure(120 * SECONDS, false);
    Client now = new Client();
    now.allocate(MEGABYTE);
    measure(1, true);
    assertSame(now, growth.next());
  }

  /** Who only asks now and then must not go because others have filled the memory. */
  @Test
  void nobodyGoesForNothing() {
    Client hog = new Client();
    Client judge = new Client();
    hog.allocate(100 * MEGABYTE);
    judge.allocate(MEGABYTE / 4);
    measure(1, true);
    assertSame(hog, growth.next());
    clients.remove(hog);
    measure(1, true);
    assertEquals(0, growth.largest());
    assertNull(growth.next());
  }

  /** It takes a while until the memory of who was asked can be collected. */
  @Test
  void whoAllocatesLittleIsSparedAsLongAsSomebodyElseFreesMuch() {
    Client hog = new Client();
    Client judge = new Client();
    Client accomplice = new Client();
    hog.allocate(100 * MEGABYTE);
    judge.allocate(4 * MEGABYTE);
    accomplice.allocate(6 * MEGABYTE);
    measure(1, true);
    assertSame(hog, growth.next());
    growth.evicted(hog);
    assertSame(accomplice, growth.next());
    assertFalse(growth.mayBeAsked(judge));
    growth.evicted(accomplice);
    now += 2_999_999_999L;
    assertEquals(0, growth.largest());
    assertNull(growth.next());
    assertFalse(growth.mayBeAsked(judge));
    now++;
    assertSame(judge, growth.next());
    assertTrue(growth.mayBeAsked(judge));
    now--;
    growth.forget();
    clients.remove(hog);
    clients.remove(accomplice);
    assertSame(judge, growth.next());
  }

  /** None of them is to be spared then. */
  @Test
  void manyThatAllocateLittleAreAskedOneAfterTheOther() {
    for (int i = 0; i < 100; i++) {
      new Client().allocate(MEGABYTE);
    }
    measure(1, true);
    for (int i = 0; i < 100; i++) {
      growth.evicted(Objects.requireNonNull(growth.next()));
    }
    assertNull(growth.next());
  }
}
