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
}
