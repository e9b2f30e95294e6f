package org.urbi.kernel.object;

/**
 * A value that is executed when a message finds it in a slot. Objects tell it from other values
 * because overwriting a slot that holds code invalidates the cached lookups of its name.
 */
public abstract class UrbiCode extends UrbiObject {
  protected UrbiCode(Shape shape) {
    super(shape);
  }
}
