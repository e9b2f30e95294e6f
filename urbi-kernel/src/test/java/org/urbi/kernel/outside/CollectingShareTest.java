package org.urbi.kernel.outside;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** When garbage collection takes too much of the time. */
class CollectingShareTest {
  private static final long SECOND = 1_000_000_000;

  private final CollectingShare share = new CollectingShare(0.8);

  private boolean isTooMuch(double now, double collecting, int count) {
    return share.isTooMuch((long) (now * SECOND), (long) (collecting * SECOND), count);
  }

  @Test
  void aSingleLongCollectionIsNotTooMuch() {
    assertFalse(isTooMuch(100, 7, 20));
    assertFalse(isTooMuch(105.2, 12, 21), "on a busy machine");
    assertFalse(isTooMuch(110.4, 17, 22));
    assertFalse(isTooMuch(119, 18, 23), "most of the time was work");
  }

  @Test
  void oneAfterTheOtherAreTooMuch() {
    assertFalse(isTooMuch(100, 7, 20));
    assertFalse(isTooMuch(101, 8, 26), "not for long");
    assertTrue(isTooMuch(102.1, 8.9, 30));
    assertTrue(isTooMuch(103, 9, 31), "until the next measurement");
    assertFalse(isTooMuch(105, 10, 34));
  }

  @Test
  void itBeginsAnewWhenMemoryIsNotScarce() {
    isTooMuch(100, 7, 20);
    assertTrue(isTooMuch(102.1, 9, 30));
    share.forget();
    assertFalse(isTooMuch(102.2, 9.1, 31));
    assertFalse(isTooMuch(110, 10, 40));
  }
}
