package org.urbi.kernel.node;

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
  private @Nullable Shape before;
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
    return (shape == last || shape == before)
        && name.epoch() == epoch
        && equality.epoch() == epochOfEquality;
  }

  void add(World world, Shape shape) {
    boolean isValid = name.epoch() == epoch && equality.epoch() == epochOfEquality;
    before = isValid ? last : null;
    last = shape;
    epoch = world.remember(name);
    epochOfEquality = world.remember(equality);
  }
}
