package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** Who reads while a condition is evaluated hears of changes afterwards. */
class DependenciesTest {
  private final World world = new World();
  private final Values values = world.values();
  private final Symbol x = world.symbol("x");
  private final List<String> told = new ArrayList<>();

  /** Watches all that some code reads; returns how many things these are. */
  private <T> int watch(T object, Consumer<T> reads, String name) {
    Set<Dependencies> read = new LinkedHashSet<>();
    world.tracker = read::add;
    reads.accept(object);
    world.tracker = null;
    read.forEach(source -> source.add(() -> told.add(name)));
    return read.size();
  }

  // ------------------------------------------------------------------ the list of watchers

  @Test
  void watchersAreToldInTheOrderInWhichTheyCame() {
    Dependencies source = new Dependencies("x");
    assertTrue(source.isEmpty());
    source.changed();
    Dependencies.Watcher first = () -> told.add("first");
    Dependencies.Watch watch = source.add(first);
    assertFalse(source.isEmpty());
    source.changed();
    assertEquals(List.of("first"), told);
    source.add(() -> told.add("second"));
    source.changed();
    assertEquals(List.of("first", "first", "second"), told);
    watch.end();
    watch.end();
    source.changed();
    assertEquals(List.of("first", "first", "second", "second"), told);
    source.add(first);
    source.changed();
    assertEquals(List.of("first", "first", "second", "second", "second", "first"), told);
  }

  @Test
  void whoGoesWhileTheOthersAreToldIsNotTold() {
    Dependencies source = new Dependencies("x");
    List<Dependencies.Watch> ended = new ArrayList<>();
    source.add(() -> {
      told.add("first");
      ended.forEach(Dependencies.Watch::end);
      source.add(() -> told.add("fourth"));
    });
    ended.add(source.add(() -> told.add("second")));
    source.add(() -> told.add("third"));
    ended.add(source.add(() -> told.add("last")));
    source.changed();
    assertEquals(List.of("first", "third"), told);
    source.changed();
    assertEquals(List.of("first", "third", "first", "third", "fourth"), told);
  }

  /** One that cannot be told now must not cost itself and the others the change. */
  @Test
  void theOthersAreToldWhenOneFails() {
    Dependencies source = new Dependencies("x");
    source.add(() -> told.add("first"));
    source.add(
        new Dependencies.Watcher() {
          @Override
          public void invalidated() {
            throw new IllegalStateException("no time");
          }

          @Override
          public void invalidatedLater() {
            told.add("later");
          }
        });
    List<Dependencies.Watch> ended = new ArrayList<>();
    source.add(() -> {
      told.add("third");
      ended.forEach(Dependencies.Watch::end);
    });
    ended.add(source.add(() -> told.add("ended")));
    source.add(() -> told.add("last"));
    Exception failed = assertThrows(IllegalStateException.class, source::changed);
    assertEquals("no time", failed.getMessage());
    assertEquals(List.of("first", "later", "third", "last"), told);
  }

  @Test
  void peopleAreToldWhatWatches() {
    Dependencies source = new Dependencies("speed");
    assertEquals("speed", source.name());
    assertEquals(0, source.size());
    assertEquals(List.of(), source.watchers(3));
    source.add(() -> {});
    for (String name : List.of("one", "two", "three")) {
      source.add(
          new Dependencies.Watcher() {
            @Override
            public void invalidated() {}

            @Override
            public String description() {
              return name;
            }
          });
    }
    assertEquals(4, source.size());
    assertEquals(List.of("", "one", "two", "three"), source.watchers(9));
    assertEquals(List.of("", "one", "two"), source.watchers(3));
    assertEquals(List.of(), source.watchers(0));
  }

  @Test
  void aWatchKnowsTheEvaluationThatReadItsSource() {
    Dependencies source = new Dependencies("x");
    Dependencies.Watch watch = source.add(() -> {});
    assertEquals(source, watch.source());
    assertFalse(watch.wasReadBy(7));
    assertTrue(watch.readBy(7));
    assertFalse(watch.readBy(7));
    assertTrue(watch.wasReadBy(7));
    assertFalse(watch.wasReadBy(8));
    assertTrue(watch.readBy(8));
    assertFalse(watch.wasReadBy(7));
  }

  // ------------------------------------------------------------------ what objects tell

  @Test
  void nothingIsNotedWhenNobodyAsks() {
    UrbiObject object = values.object.cloned();
    object.addSlot(x, values.nil);
    object.noteSlotRead(x);
    object.noteStructureRead();
    object.noteContentRead();
    assertNull(object.slotData(x));
  }

  @Test
  void aSlotThatWasReadIsWatchedAndSpecial() {
    UrbiObject object = values.object.cloned();
    object.addSlot(x, values.nil);
    assertEquals(1, watch(object, o -> o.noteSlotRead(x), "read"));
    assertTrue(object.shape().writeSpecial(0));
    Dependencies dependents = object.slotData(x).dependents();
    assertEquals(1, watch(object, o -> o.noteSlotRead(x), "again"));
    assertEquals(dependents, object.slotData(x).dependents());
    object.removeSlot(x);
    assertEquals(List.of("read", "again"), told);
  }

  @Test
  void whoAsksWhichSlotsThereAreHearsOfThem() {
    for (int way = 0; way < 4; way++) {
      UrbiObject object = values.object.cloned();
      int how = way;
      int read =
          watch(
              object,
              o -> {
                switch (how) {
                  case 0 -> o.hasLocalSlot(x);
                  case 1 -> o.localSlotNames();
                  case 2 -> o.protos();
                  default -> o.noteStructureRead();
                }
              },
              "structure");
      assertEquals(1, read);
      told.clear();
      object.addSlot(x, values.nil);
      assertEquals(1, told.size());
      object.setSlotAt(0, values.object);
      assertEquals(1, told.size());
      object.removeSlot(x);
      assertEquals(2, told.size());
      object.setProtos(values.object);
      assertEquals(3, told.size());
      assertFalse(object.removeSlot(x));
      assertEquals(3, told.size());
    }
  }

  @Test
  void whoReadTheStructureTwiceWatchesOneThing() {
    UrbiObject object = values.object.cloned();
    List<Dependencies> read = new ArrayList<>();
    world.tracker = read::add;
    object.noteStructureRead();
    object.noteStructureRead();
    object.noteContentRead();
    object.noteContentRead();
    world.tracker = null;
    assertEquals(4, read.size());
    assertEquals(read.get(0), read.get(1));
    assertEquals(read.get(2), read.get(3));
    assertFalse(read.get(0) == read.get(2));
  }

  @Test
  void whoReadAContainerHearsOfItsContent() {
    UrbiList list = values.list(List.of(values.nil));
    assertEquals(1, watch(list, UrbiList::elements, "list"));
    list.modify().clear();
    list.noteContentChange();
    UrbiDictionary dictionary = values.dictionary(Map.of());
    assertEquals(1, watch(dictionary, UrbiDictionary::entries, "entries"));
    assertEquals(1, watch(dictionary, UrbiDictionary::sorted, "sorted"));
    dictionary.noteContentChange();
    UrbiString string = values.string("a");
    assertEquals(1, watch(string, UrbiString::value, "string"));
    string.setValue("b");
    UrbiTuple tuple = values.tuple(List.of(values.nil, values.object));
    assertEquals(1, watch(tuple, t -> t.get(0), "get"));
    assertEquals(1, watch(tuple, UrbiTuple::elements, "elements"));
    tuple.set(1, values.nil);
    tuple.setElements(List.of());
    assertEquals(
        List.of("list", "entries", "sorted", "string", "get", "elements", "get", "elements"), told);
  }

  @Test
  void aLongStringThatGrowsHasBeenRead() {
    UrbiString half = values.string("x".repeat(1000));
    assertEquals(1, watch(half, h -> values.concatenation(h, "y".repeat(1000)), "half"));
    half.setValue("");
    assertEquals(List.of("half"), told);
    UrbiString grown = values.concatenation(values.string("z".repeat(2000)), "z");
    assertEquals(1, watch(grown, g -> values.concatenation(g, "z"), "grown"));
  }

  @Test
  void thoseWhoWatchTheContentNeedNotReadIt() {
    UrbiList list = values.list(List.of());
    list.noteContentChange();
    list.watchContent(() -> told.add("first"));
    list.watchContent(() -> told.add("second"));
    list.noteContentChange();
    assertEquals(List.of("first", "second"), told);
  }
}
