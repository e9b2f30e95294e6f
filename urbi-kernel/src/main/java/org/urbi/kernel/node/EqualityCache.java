package org.urbi.kernel.node;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.World;

/**
 * The shapes of the last left operands that one place in the code compares by {@code ==} or {@code
 * !=} of the library, as long as nobody touches a slot of these names.
 */
final class EqualityCache {
  private final Symbol name;
  private final Symbol equality;
  private @Nullable Shape last;

  /** Those before, latest first. */
  private final @Nullable Shape[] before = new Shape[3];

  private int epoch = -1;
  private int epochOfEquality = -1;

  /**
   * @param name the operator
   * @param equality {@code ==}, by which {@code !=} is defined
   */
  EqualityCache(Symbol name, Symbol equality) {
    this.name = name;
    this.equality = equality;
  }

  boolean has(Shape shape) {
    return (shape == last || wasBefore(shape))
        && name.epoch() == epoch
        && equality.epoch() == epochOfEquality;
  }

  private boolean wasBefore(Shape shape) {
    for (Shape known : before) {
      if (known == shape) {
        return true;
      }
    }
    return false;
  }

  void add(World world, Shape shape) {
    if (name.epoch() != epoch || equality.epoch() != epochOfEquality) {
      Arrays.fill(before, null);
      last = null;
    }
    System.arraycopy(before, 0, before, 1, before.length - 1);
    before[0] = last;
    last = shape;
    epoch = world.remember(name);
    epochOfEquality = world.remember(equality);
  }
}
