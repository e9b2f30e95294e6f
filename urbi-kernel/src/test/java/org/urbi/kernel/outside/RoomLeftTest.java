package org.urbi.kernel.outside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** When garbage collection leaves too little room. */
class RoomLeftTest {
  private static final long SECOND = 1_000_000_000;
  private static final double PERIOD = 0.25;

  private final RoomLeft room = new RoomLeft();
  private double now = 100;
  private double collecting;
  private int whole;

  private boolean isTooLittle(double used) {
    return room.isTooLittle(
        (long) (now * SECOND), used, (long) (collecting * SECOND), whole, whole);
  }

  /**
   * All garbage is collected again and again.
   *
   * @param used what that leaves in use
   * @param every how many seconds there are from one to the next
   * @param taking how many seconds each takes
   * @param patience for how many seconds it is looked
   * @return after how many seconds there is too little room, infinite if never
   */
  private double actsAfter(double used, double every, double taking, double patience) {
    double began = now;
    double next = now;
    for (; now < began + patience; now += PERIOD) {
      if (now >= next) {
        whole++;
        collecting += taking;
        next += every;
      }
      if (isTooLittle(used)) {
        return now - began;
      }
    }
    return Double.POSITIVE_INFINITY;
  }

  @Test
  void nearlyNoneIsTooLittleAtOnce() {
    assertTrue(isTooLittle(0.93));
    assertFalse(isTooLittle(0.91));
  }

  /**
   * So much that a client who makes little garbage keeps the others from their periods for ever.
   */
  @Test
  void littleIsTooLittleWhenCollectionsTakeMuchOfTheTime() {
    assertEquals(3, actsAfter(0.9, 1, 0.3, 60));
  }

  @Test
  void littleIsTooLittleEvenIfTheyComeSeldomButTakeLong() {
    assertEquals(9, actsAfter(0.88, 3, 0.9, 60));
  }

  @Test
  void littleIsEnoughWhenCollectionsTakeLittleOfTheTime() {
    assertEquals(Double.POSITIVE_INFINITY, actsAfter(0.9, 3, 0.4, 60));
  }

  @Test
  void whereThereIsRoomTheyMayTakeMuchOfTheTime() {
    assertEquals(Double.POSITIVE_INFINITY, actsAfter(0.8, 1, 0.7, 60));
    assertEquals(2.25, actsAfter(0.8, 0.5, 0.5, 60), "but not nearly all");
  }

  /** What was measured while there was more room says nothing. */
  @Test
  void itIsMeasuredFromWhenThereIsLittle() {
    actsAfter(0.8, 1, 0.7, 10);
    assertFalse(isTooLittle(0.9));
  }

  @Test
  void itIsMeasuredAnewWhenSomebodyHasBeenAsked() {
    actsAfter(0.9, 1, 0.3, 60);
    assertTrue(isTooLittle(0.9));
    room.expectRelief();
    assertFalse(isTooLittle(0.9));
    assertEquals(2.25, actsAfter(0.9, 1, 0.3, 60), "it has not helped");
    room.forget();
    assertFalse(isTooLittle(0.9));
  }
}
