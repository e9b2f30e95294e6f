package org.urbi.kernel.node;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

class EqualityCacheTest {
  private final World world = new World();
  private final Symbol equality = world.symbol("==");
  private final EqualityCache cache = new EqualityCache(world.symbol("!="), equality);
  private final List<Shape> shapes =
      Stream.of("a", "b", "c", "d", "e")
          .map(name -> objectWith(world.symbol(name)).shape())
          .toList();

  private UrbiObject objectWith(Symbol name) {
    var object = new UrbiObject(world.orphanShape());
    object.addSlot(name, object);
    return object;
  }

  private void add(int from, int to) {
    shapes.subList(from, to).forEach(shape -> cache.add(world, shape));
  }

  @Test
  void fourShapesAreKnownAtAPlace() {
    add(0, 4);
    assertTrue(shapes.subList(0, 4).stream().allMatch(cache::has));
    assertFalse(cache.has(shapes.get(4)));
  }

  @Test
  void theFifthTakesThePlaceOfTheOldest() {
    add(0, 5);
    assertFalse(cache.has(shapes.get(0)));
    assertTrue(shapes.subList(1, 5).stream().allMatch(cache::has));
  }

  @Test
  void allAreForgottenWhenSomebodyMayCompareInAnotherWay() {
    add(0, 4);
    var prototype = new UrbiObject(world.orphanShape());
    new UrbiObject(prototype.cloneShape());
    prototype.addSlot(equality, prototype);
    assertFalse(shapes.stream().anyMatch(cache::has));
    add(4, 5);
    assertTrue(cache.has(shapes.get(4)));
    assertFalse(shapes.subList(0, 4).stream().anyMatch(cache::has));
  }
}
