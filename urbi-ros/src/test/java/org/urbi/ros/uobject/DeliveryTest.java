package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class DeliveryTest {
  private static final int MANY = 100_000;

  private final List<Integer> seen = new ArrayList<>();
  private int calls;
  private final Delivery<Integer> delivery = new Delivery<>(() -> calls++);

  /** The kernel: makes the calls that are asked for. */
  private void turns() {
    for (int made = 0; made < calls; made++) {
      delivery.take(seen::add);
    }
  }

  @Test
  void whoSendsWithoutEndLeavesTheKernelItsTurns() {
    delivery.begin(0);
    delivery.offer(0);
    delivery.take(taken -> {
      seen.add(taken);
      if (taken < MANY) {
        delivery.offer(taken + 1);
      }
    });
    assertTrue(seen.size() < MANY / 100, () -> seen.size() + " in one turn");
    assertEquals(2, calls, "another turn is asked for");
  }

  @Test
  void nothingIsLostFromTurnToTurn() {
    delivery.begin(0);
    List<Integer> sent = new ArrayList<>();
    for (int i = 0; i < 777; i++) {
      sent.add(i);
      delivery.offer(i);
    }
    turns();
    assertEquals(sent, seen);
    delivery.offer(777);
    turns();
    assertEquals(778, seen.size());
  }

  @Test
  void aMessageThatCannotBeShownIsNotTheLast() {
    delivery.begin(0);
    delivery.offer(1);
    delivery.offer(2);
    assertThrows(
        IllegalStateException.class,
        () ->
            delivery.take(taken -> {
              throw new IllegalStateException("refused");
            }));
    delivery.offer(3);
    turns();
    assertEquals(List.of(2, 3), seen);
  }

  @Test
  void theNewestAreKept() {
    delivery.begin(2);
    for (int i = 0; i < 5; i++) {
      delivery.offer(i);
    }
    turns();
    assertEquals(List.of(3, 4), seen);
  }

  @Test
  void whatWaitsAtTheEndIsForgotten() {
    delivery.begin(0);
    delivery.offer(1);
    delivery.end();
    delivery.offer(2);
    turns();
    assertEquals(List.of(), seen);
  }
}
