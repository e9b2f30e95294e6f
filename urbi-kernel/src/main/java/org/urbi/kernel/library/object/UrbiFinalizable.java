package org.urbi.kernel.library.object;

import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/**
 * An object whose {@code finalize} is called when it is no longer referenced (manual,
 * "Finalizable").
 */
public final class UrbiFinalizable extends UrbiObject {
  private final Finalization finalization;
  private final long number;

  /**
   * @param finalization the finalization of the kernel, called when the object is reclaimed
   * @param number 0 for the prototype, which is never reclaimed
   */
  private UrbiFinalizable(Shape shape, Finalization finalization, long number) {
    super(shape);
    this.finalization = finalization;
    this.number = number;
  }

  static UrbiFinalizable prototype(Shape shape) {
    return new UrbiFinalizable(shape, new Finalization(), 0);
  }

  /** That of the kernel of this object. */
  public Finalization finalization() {
    return finalization;
  }

  /** Objects are numbered in the order in which they were made. */
  long number() {
    return number;
  }

  @Override
  public UrbiObject cloned() {
    var made = new UrbiFinalizable(cloneShape(), finalization, finalization.nextNumber());
    finalization.add(made);
    return made;
  }

  /**
   * Only a Java finalizer gets the unreferenced object itself with its slots; references and
   * cleaners do not.
   */
  @Override
  @SuppressWarnings({"deprecation", "removal", "Finalize"})
  protected void finalize() {
    if (number > 0) {
      finalization.reclaimed(this);
    }
  }
}
