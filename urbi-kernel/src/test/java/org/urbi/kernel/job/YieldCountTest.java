package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;

class YieldCountTest {
  private final YieldCount yields = new YieldCount(new Inbox(Journal.NONE));

  /** How many pass before the next one has to look. */
  private int passing() {
    int passing = 0;
    while (yields.passes()) {
      passing++;
    }
    return passing;
  }

  @Test
  void ninetyEightPassAfterOneThatHasLooked() {
    assertFalse(yields.passes());
    assertFalse(yields.isOver());
    yields.grant(Long.MAX_VALUE);
    assertEquals(98, passing());
    yields.endGrant();
    assertEquals(99, yields.count());
    assertEquals(99, yields.passed());
    assertTrue(yields.isOver());
  }

  @Test
  void whatHasPassedIsKnownAtAnyTime() {
    yields.isOver();
    yields.grant(10);
    assertEquals(1, yields.passed());
    yields.passes();
    yields.passes();
    assertEquals(3, yields.passed());
    yields.endGrant();
    assertEquals(3, yields.passed());
    assertEquals(3, yields.count());
  }

  @Test
  void whenSomebodyElseMayRunTheNextOneLooks() {
    yields.isOver();
    yields.grant(Long.MAX_VALUE);
    yields.passes();
    yields.endGrant();
    assertFalse(yields.passes());
  }

  @Test
  void noMorePassThanAreGranted() {
    yields.isOver();
    yields.grant(3);
    assertEquals(3, passing());
    yields.endGrant();
    yields.grant(0);
    assertEquals(0, passing());
    yields.endGrant();
    yields.grant(-5);
    assertEquals(0, passing());
  }

  @Test
  void whatALoopHasBorrowedAndUsedHasPassed() {
    yields.isOver();
    yields.grant(10);
    assertEquals(10, yields.borrow());
    assertFalse(yields.passes());
    yields.giveBack(7);
    assertEquals(4, yields.passed());
    assertEquals(7, passing());
    yields.endGrant();
    assertEquals(11, yields.passed());
    assertEquals(11, yields.count());
  }

  @Test
  void whoBorrowsAgainHasUsedAll() {
    yields.isOver();
    yields.grant(10);
    yields.borrow();
    assertEquals(0, yields.borrow());
    assertEquals(11, yields.passed());
    yields.endGrant();
    assertEquals(11, yields.count());
  }

  @Test
  void nothingIsLentWhenThereAreNews() {
    var inbox = new Inbox(Journal.NONE);
    var count = new YieldCount(inbox);
    count.isOver();
    count.grant(10);
    inbox.post(new Message.Shutdown(0));
    assertEquals(0, count.borrow());
    count.endGrant();
    assertEquals(1, count.passed());
  }

  @Test
  void whatComesBackAfterTheGrantIsNotLeftOfAnother() {
    yields.isOver();
    yields.grant(10);
    yields.borrow();
    yields.endGrant();
    yields.giveBack(7);
    assertFalse(yields.passes());
    assertEquals(1, yields.passed());
  }

  /** So many yields have taken that long; the next one is granted. */
  private void lookAfter(long nanoseconds) {
    yields.beginTick(0);
    yields.reset();
    while (!yields.isOver()) {
      // Each of them is counted.
    }
    assertFalse(yields.look(nanoseconds));
    yields.reset();
    yields.isOver();
    yields.grant(Long.MAX_VALUE);
  }

  @Test
  void aLoopBorrowsWhatFitsBetweenTwoLooks() {
    lookAfter(12_500);
    assertEquals(798, yields.borrow());
    yields.giveBack(600);
    assertEquals(199, yields.passed());
    // What others would have had is used first.
    assertEquals(0, passing());
    assertEquals(600, yields.borrow());
    assertEquals(0, yields.borrow());
    yields.endGrant();
    assertEquals(799, yields.passed());
    assertEquals(799, yields.count());
    assertTrue(yields.isOver());
  }

  @Test
  void whoOnlyAsksGetsNoMoreBecauseALoopBorrowed() {
    lookAfter(12_500);
    assertEquals(798, yields.borrow());
    yields.giveBack(788);
    assertEquals(88, passing());
    assertEquals(99, yields.passed());
    yields.endGrant();
    assertEquals(99, yields.count());
    assertTrue(yields.isOver());
  }

  @Test
  void aLoopBorrowsAThousandAtMost() {
    lookAfter(1);
    assertEquals(998, yields.borrow());
  }

  @Test
  void aLoopBorrowsNoMoreThanOthersGetWhereTheyAreSlow() {
    lookAfter(500_000);
    assertEquals(18, yields.borrow());
    yields.endGrant();
    yields.grant(0);
    assertEquals(0, yields.borrow());
  }

  @Test
  void inSimulatedTimeNothingIsSpare() {
    yields.isOver();
    yields.grant(900);
    assertEquals(98, yields.borrow());
  }

  @Test
  void nothingIsSpareWhereEachHasToLook() {
    lookAfter(500);
    yields.endGrant();
    yields.grant(0);
    assertEquals(0, yields.borrow());
  }
}
