package org.urbi.kernel.event;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.object.Dependencies;

/** What evaluations read is watched once, and only as long as each of them reads it. */
class WatchedSourcesTest {
  private final List<Dependencies> sources = new ArrayList<>();
  private int calls;
  private final WatchedSources watched = new WatchedSources(() -> calls++);

  WatchedSourcesTest() {
    for (int i = 0; i < 40; i++) {
      sources.add(new Dependencies("x"));
    }
  }

  private void evaluate(List<Integer> read) {
    watched.begin();
    read.forEach(i -> watched.read(sources.get(i)));
    watched.end();
    assertCalls(read);
  }

  /** Each source that was read calls once, and no other one does. */
  private void assertCalls(List<Integer> read) {
    for (int i = 0; i < sources.size(); i++) {
      calls = 0;
      sources.get(i).changed();
      assertEquals(read.contains(i) ? 1 : 0, calls, i + " after " + read);
      assertEquals(!read.contains(i), sources.get(i).isEmpty());
    }
  }

  @Test
  void whatIsReadTwiceIsWatchedOnce() {
    evaluate(List.of(0, 1, 0, 1, 1));
    evaluate(List.of(0, 1, 0, 1, 1));
    evaluate(List.of(1, 0, 0));
    evaluate(List.of(0, 0));
  }

  @Test
  void whatIsReadNoMoreIsWatchedNoMore() {
    evaluate(List.of(0, 1, 2));
    evaluate(List.of(0, 2));
    evaluate(List.of());
    evaluate(List.of(2, 1, 3));
  }

  @Test
  void whatWasReadBeforeIsWatchedUntilTheEvaluationHasEnded() {
    evaluate(List.of(0, 1));
    watched.begin();
    assertCalls(List.of(0, 1));
    watched.read(sources.get(2));
    assertCalls(List.of(0, 1, 2));
    watched.end();
    assertCalls(List.of(2));
  }

  @Test
  void nothingIsWatchedAfterTheEnd() {
    evaluate(List.of(0, 1));
    watched.begin();
    watched.read(sources.get(2));
    watched.close();
    assertCalls(List.of());
  }

  @Test
  void manyThingsInAnyOrder() {
    Random random = new Random(1);
    for (int times = 0; times < 300; times++) {
      List<Integer> read = new ArrayList<>();
      for (int i = random.nextInt(60); i > 0; i--) {
        read.add(random.nextInt(sources.size()));
      }
      evaluate(read);
      evaluate(read);
    }
  }
}
