package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Strings and binaries: what they contain, and who is told when it changes. */
class ContentTest {
  private final World world = new World();
  private final Values values = world.values();
  private final UrbiString text = values.string("text");
  private final UrbiBinary binary =
      new UrbiBinary(values.object.cloneShape(), "jpeg 3 2", "\u00ff\u0000");
  private int changes;

  /** Reads while a condition is evaluated, and what it has read. */
  private Set<Dependencies> readBy(Runnable condition) {
    Set<Dependencies> read = new HashSet<>();
    world.tracker = read::add;
    condition.run();
    world.tracker = null;
    return read;
  }

  private void watchedBy(UrbiObject container, Runnable change) {
    changes = 0;
    container.watchContent(() -> changes++);
    change.run();
    assertTrue(changes > 0, "nobody was told");
  }

  @Test
  void partsOfAStringAreReadAndReplaced() {
    assertEquals(4, text.length());
    assertEquals("ex", text.part(1, 3));
    text.replace(1, 2, "E");
    assertEquals("tEx", text.part(0, 3));
    assertEquals("tExt", text.value());
    text.replace(1, 3, "he nex");
    assertEquals("the next", text.value());
    assertEquals(8, text.length());
    text.replace(0, 4, "");
    assertEquals("next", text.value());
    text.replace(0, 1, "con");
    text.replace(3, 6, "!");
    assertEquals("con!", text.value());
    text.setValue("other");
    text.replace(0, 1, "O");
    assertEquals("Other", text.value());
  }

  /** Long strings share what they begin with. */
  @Test
  void whatIsAppendedToALongStringChangesNoOther() {
    for (int length : new int[] {1, 500, 1023, 1024, 3000}) {
      UrbiString first = values.string("x".repeat(length));
      List<UrbiString> all = new ArrayList<>(List.of(first));
      for (int i = 0; i < 5; i++) {
        all.add(all.getLast().followedBy(text.cloneShape(), "-" + i));
      }
      UrbiString branch = all.get(2).followedBy(text.cloneShape(), "branch");
      first.replace(0, 1, "A");
      all.get(3).replace(1, 2, "");
      UrbiString late = all.get(3).followedBy(text.cloneShape(), "late");
      String x = "x".repeat(length);
      assertEquals("A" + x.substring(1), first.value());
      assertEquals(x + "-0", all.get(1).value());
      assertEquals(length + 2, all.get(1).length());
      assertEquals("-0-1", all.get(2).part(length, length + 4));
      assertEquals(x + "-0-1branch", branch.value());
      String third = (x + "-0-1-2").substring(0, 1) + (x + "-0-1-2").substring(2);
      assertEquals(third, all.get(3).value());
      assertEquals(third + "late", late.value());
      assertEquals(x + "-0-1-2-3", all.get(4).value());
      assertEquals(x + "-0-1-2-3-4", all.get(5).value());
    }
  }

  @Test
  void aBinaryHasKeywordsAndData() {
    assertEquals("jpeg 3 2", binary.keywords());
    assertEquals("\u00ff\u0000", binary.data());
    UrbiBinary copy = (UrbiBinary) binary.cloned();
    assertNotSame(binary, copy);
    assertSame(binary, copy.protos()[0]);
    binary.setKeywords("raw");
    binary.setData("1");
    assertEquals("raw", binary.keywords());
    assertEquals("1", binary.data());
    assertEquals("jpeg 3 2", copy.keywords());
    assertEquals("\u00ff\u0000", copy.data());
  }

  @Test
  void aConditionThatReadsThemIsToldOfChanges() {
    assertEquals(1, readBy(text::value).size());
    assertEquals(1, readBy(text::length).size());
    assertEquals(1, readBy(() -> text.part(0, 1)).size());
    assertEquals(1, readBy(() -> text.followedBy(text.cloneShape(), "x".repeat(2000))).size());
    assertEquals(1, readBy(binary::keywords).size());
    assertEquals(1, readBy(binary::data).size());
    watchedBy(text, () -> text.setValue("other"));
    watchedBy(text, () -> text.replace(0, 1, "O"));
    watchedBy(binary, () -> binary.setKeywords("raw"));
    watchedBy(binary, () -> binary.setData("1"));
  }

  /** Where a name was looked for in vain, it may appear: in the object and in its ancestors. */
  @Test
  void aConditionThatFindsNoSlotIsToldWhenThereIsOne() {
    UrbiObject parent = values.object.cloned();
    UrbiObject child = parent.cloned();
    Set<Dependencies> read = readBy(child::noteAbsence);
    assertTrue(read.size() >= 3, "child, parent and object: " + read.size());
    for (UrbiObject each : List.of(child, parent)) {
      changes = 0;
      read.forEach(source -> source.add(() -> changes++));
      each.addSlot(world.symbol("appears"), text);
      assertTrue(changes > 0, "nobody was told");
    }
    assertEquals(0, readBy(() -> {}).size());
  }

  @Test
  void anObjectBelongsToALobbyOrNobody() {
    UrbiObject object = values.object.cloned();
    assertNull(object.ownerLobby());
    assertTrue(object.uid() > 0);
    assertNull(object.ownerLobby());
    object.setOwnerLobby(text);
    assertSame(text, object.ownerLobby());
  }
}
