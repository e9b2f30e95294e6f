package org.urbi.kernel.observe;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;

/** Values as people who look at them see them, however large, and of which kind they are. */
class SeenValueTest {
  private static final int MOST = 10_000;

  private final World world = new World();
  private final Values values = world.values();

  private Object seen(UrbiObject... elements) {
    return SeenValue.of(values.list(List.of(elements)));
  }

  @Test
  void plainValuesAreCopied() {
    assertEquals(1.5, SeenValue.of(values.number(1.5)));
    assertEquals(true, SeenValue.of(values.trueObject));
    assertEquals(false, SeenValue.of(values.falseObject));
    assertEquals("text", SeenValue.of(values.string("text")));
    assertEquals(List.of(1.0, "a"), seen(values.number(1), values.string("a")));
    assertEquals(List.of(2.0), SeenValue.of(values.tuple(List.of(values.number(2)))));
  }

  @Test
  void othersAreNothingAloneAndTheirTypeAmongOthers() {
    UrbiObject robot = values.object.cloned();
    robot.addSlot(world.symbol("type"), values.string("Robot"));
    assertNull(SeenValue.of(robot));
    assertNull(SeenValue.of(values.nil));
    assertNull(SeenValue.of(values.voidObject));
    assertEquals(
        Arrays.asList("Robot", "Object", null, null),
        seen(robot, values.object.cloned(), values.nil, values.voidObject));
  }

  /** A list that contains itself, twice. */
  @Test
  void whatContainsItselfEnds() {
    UrbiList list = values.list(List.of());
    list.elements().add(list);
    list.elements().add(list);
    assertTrue(elements(SeenValue.of(list)) <= MOST);
  }

  private static int elements(Object seen) {
    int count = 0;
    if (seen instanceof List<?> list) {
      for (Object each : list) {
        count += 1 + elements(each);
      }
    }
    return count;
  }

  @Test
  void longListsAreCut() {
    List<UrbiObject> many = Collections.nCopies(MOST + 5, values.number(1));
    assertEquals(MOST, ((List<?>) SeenValue.of(values.list(many))).size());
    List<?> two = (List<?>) seen(values.list(many), values.number(3));
    assertEquals(1, two.size(), "nothing is left for what follows");
    assertEquals(MOST - 1, ((List<?>) two.getFirst()).size());
  }

  @Test
  void kindsFollowFromValues() {
    assertEquals(VariableKind.NUMBER, VariableKind.of(1.0));
    assertEquals(VariableKind.BOOLEAN, VariableKind.of(true));
    assertEquals(VariableKind.TEXT, VariableKind.of("1"));
    assertEquals(VariableKind.NUMBERS, VariableKind.of(List.of(1.0, 2.0)));
    assertEquals(VariableKind.LIST, VariableKind.of(List.of(1.0, "2")));
    assertEquals(VariableKind.DICTIONARY, VariableKind.of(Map.of()));
    assertEquals(VariableKind.IMAGE, VariableKind.of(new Bytes(" jpeg  320 240", "")));
    assertEquals(VariableKind.BINARY, VariableKind.of(new Bytes("", "")));
    assertArrayEquals(new byte[] {(byte) 0xff, 0}, new Bytes("", "\u00ff\0").bytes());
  }

  /** Numbers become a list with the first other element, and no kind is a number again. */
  @Test
  void kindsWidenOnly() {
    VariableKind numbers = VariableKind.NUMBERS;
    assertEquals(numbers, numbers.with(VariableKind.NUMBERS));
    assertEquals(VariableKind.LIST, numbers.with(VariableKind.LIST));
    assertEquals(VariableKind.LIST, VariableKind.LIST.with(VariableKind.NUMBERS));
    assertEquals(VariableKind.ANY, numbers.with(VariableKind.NUMBER));
    assertEquals(VariableKind.ANY, VariableKind.NUMBER.with(VariableKind.TEXT));
    for (VariableKind each : VariableKind.values()) {
      assertEquals(VariableKind.ANY, VariableKind.ANY.with(each));
      assertEquals(each, each.with(each));
    }
  }
}
