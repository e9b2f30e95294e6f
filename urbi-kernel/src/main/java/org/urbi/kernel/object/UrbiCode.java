package org.urbi.kernel.object;

/**
 * What is executed when it is the value of a message. Objects know it from other values because a
 * slot that holds code and is overwritten ends what lookup sites have remembered of its name.
 */
public abstract class UrbiCode extends UrbiObject {
  protected UrbiCode(Shape shape) {
    super(shape);
  }
}
