package org.urbi.kernel.observe;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What somebody who looks at rows is sent, and which ways to slots he may name. */
class SentRowsTest {
  private record Row(String text) {}

  private final SentRows<Integer, Row> rows = new SentRows<>();

  private void look(String... texts) {
    for (int i = 0; i < texts.length; i++) {
      if (!texts[i].isEmpty()) {
        rows.is(i, new Row(texts[i]));
      }
    }
  }

  @Test
  void changesAreSentOnce() {
    look("a", "b");
    assertEquals(List.of(new Row("a"), new Row("b")), rows.changes());
    assertEquals(List.of(), rows.gone());
    look("a", "c");
    assertEquals(List.of(new Row("c")), rows.changes());
    assertEquals(List.of(), rows.gone());
    look("a", "c");
    assertEquals(List.of(), rows.changes());
  }

  @Test
  void whatIsGoneIsSentOnceAndNewWhenItComesBack() {
    look("a", "b");
    rows.changes();
    rows.gone();
    look("", "b");
    assertEquals(List.of(), rows.changes());
    assertEquals(List.of(0), rows.gone());
    look("", "b");
    assertEquals(List.of(), rows.gone());
    look("a", "b");
    assertEquals(List.of(new Row("a")), rows.changes());
    assertEquals(List.of(), rows.gone());
  }

  @Test
  void nobodyLeftIsGone() {
    look("a", "b");
    rows.gone();
    assertEquals(2, rows.gone().size());
    assertEquals(0, rows.gone().size());
  }

  @ParameterizedTest
  @ValueSource(strings = {"x", "robot.body.x", "_a1.b_2"})
  void namesWithPeriodsArePaths(String text) {
    assertTrue(SlotPath.isPath(text));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", ".", "a.", ".a", "a..b", "1a", "a.1", "a b", "a;b", "a.b()", "a\n"})
  void othersAreNot(String text) {
    assertFalse(SlotPath.isPath(text));
  }

  /** Whoever names the longest way that there could be. */
  @Test
  void longPathIsOne() {
    assertTrue(SlotPath.isPath("a.".repeat(1 << 17) + "b"));
    assertFalse(SlotPath.isPath("a.".repeat(1 << 17)));
  }
}
