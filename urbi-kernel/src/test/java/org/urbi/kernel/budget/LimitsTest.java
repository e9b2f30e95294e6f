package org.urbi.kernel.budget;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a budget allows, as options say it, and whose use counts where. */
class LimitsTest {
  private final List<String> monitored = new ArrayList<>();
  private final Budget budget = new Budget((what, most) -> monitored.add(what.word() + most));

  @Test
  void nothingIsLimitedAtFirst() {
    for (Resource each : Resource.values()) {
      assertEquals(Budget.UNLIMITED, budget.limit(each));
      assertTrue(budget.take(each));
    }
    assertEquals(List.of(), monitored);
  }

  @Test
  void optionsHaveUnitsAndBlanks() {
    budget.setLimits(" jobs = 100 ,output=3k,input=2M,memory=1G,time=20%");
    assertEquals(100, budget.limit(Resource.JOBS));
    assertEquals(3 << 10, budget.limit(Resource.OUTPUT));
    assertEquals(2 << 20, budget.limit(Resource.INPUT));
    assertEquals(1 << 30, budget.limit(Resource.MEMORY));
    assertEquals(20, budget.limit(Resource.TIME));
    assertEquals(Budget.UNLIMITED, budget.limit(Resource.DEPTH));
    assertEquals(
        List.of("jobs100", "output3072", "input2097152", "memory1073741824", "time20"), monitored);
    budget.setLimits(" ");
    assertEquals(5, monitored.size());
  }

  /** The largest numbers that are accepted are no negative limits. */
  @Test
  void largestNumberStaysPositive() {
    budget.setLimits("memory=999999999999999k,depth=999999999999999");
    assertTrue(budget.limit(Resource.MEMORY) > 0, "memory " + budget.limit(Resource.MEMORY));
    assertEquals(999_999_999_999_999L, budget.limit(Resource.DEPTH));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "jobs",
        "jobs=",
        "jobs=-1",
        "jobs=1.5",
        "jobs=1T",
        "jobs=1,",
        ",",
        "jobs=9999999999999999",
        "Jobs=1",
        "patience=1"
      })
  void nonsenseIsRefused(String options) {
    assertThrows(IllegalArgumentException.class, () -> budget.setLimits(options));
  }

  @Test
  void nothingIsTakenBeyondTheLimit() {
    budget.setLimit(Resource.JOBS, 2);
    assertTrue(budget.take(Resource.JOBS) && budget.take(Resource.JOBS));
    assertFalse(budget.take(Resource.JOBS));
    assertEquals(2, budget.used(Resource.JOBS));
    budget.giveBack(Resource.JOBS);
    assertTrue(budget.take(Resource.JOBS));
    budget.setLimit(Resource.JOBS, 1);
    assertEquals(2, budget.used(Resource.JOBS), "what is in use stays");
    budget.giveBack(Resource.JOBS);
    assertFalse(budget.take(Resource.JOBS));
  }

  @Test
  void useCountsForWhatItHasJoined() {
    Budget common = new Budget();
    int[] changes = new int[1];
    common.whenUseChanges(() -> changes[0]++);
    budget.take(Resource.TIMERS);
    assertSame(budget, budget.account());
    budget.join(common);
    assertSame(common, budget.account());
    assertEquals(1, common.used(Resource.TIMERS));
    budget.take(Resource.TIMERS);
    budget.giveBack(Resource.TIMERS);
    budget.giveBack(Resource.TIMERS);
    assertEquals(0, common.used(Resource.TIMERS));
    assertEquals(4, changes[0]);
  }

  @Test
  void shorterLimitOfHoldingApplies() {
    long second = 1_000_000_000;
    assertEquals(second, budget.holdLimit(second));
    budget.setLimit(Resource.HOLD, 20);
    assertEquals(20_000_000, budget.holdLimit(second));
    budget.setLimit(Resource.HOLD, 5000);
    assertEquals(second, budget.holdLimit(second));
  }

  @Test
  void jobsOfAClientThatHasLeftDoNotHoldTheKernelForEver() {
    assertEquals(Budget.UNLIMITED, budget.holdLimit(Budget.UNLIMITED));
    budget.abandon();
    assertEquals(1_000_000_000, budget.holdLimit(Budget.UNLIMITED));
    assertEquals(List.of("hold1000"), monitored);
    long ofTheKernel = 5_000_000_000L;
    assertEquals(ofTheKernel, budget.holdLimit(ofTheKernel));
    assertEquals(Budget.UNLIMITED, budget.limit(Resource.HOLD), "programs do not see it");
    budget.setLimit(Resource.HOLD, 20);
    assertEquals(20_000_000, budget.holdLimit(Budget.UNLIMITED));
  }

  @Test
  void memoryLimitsJobsUnlessOptionsDo() {
    budget.setLimits(Budget.fitting(1 << 30, ""));
    assertEquals(131_072, budget.limit(Resource.JOBS));
    budget.setLimits(Budget.fitting(1 << 30, "jobs=7"));
    assertEquals(7, budget.limit(Resource.JOBS));
  }

  @Test
  void resourcesHaveDistinctWordsAndUnits() {
    int count = Resource.values().length;
    assertEquals(count, Stream.of(Resource.values()).map(Resource::unit).distinct().count());
    for (Resource each : Resource.values()) {
      assertSame(each, Resource.of(each.word()));
    }
  }
}
