package org.urbi.kernel.library;

import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** An object that does something when nobody refers to it any more (manual, "Finalizable"). */
final class UrbiFinalizable extends UrbiObject {
  private final Finalization finalization;
  private final long number;

  /**
   * @param finalization told when the object is reclaimed; null for the prototype
   */
  private UrbiFinalizable(Shape shape, Finalization finalization, long number) {
    super(shape);
    this.finalization = finalization;
    this.number = number;
  }

  static UrbiFinalizable prototype(Shape shape) {
    return new UrbiFinalizable(shape, null, 0);
  }

  /** A new object. */
  static UrbiFinalizable create(UrbiObject prototype, Finalization finalization) {
    UrbiFinalizable made =
        new UrbiFinalizable(prototype.cloneShape(), finalization, finalization.nextNumber());
    finalization.add(made);
    return made;
  }

  /** Objects are numbered in the order in which they were made. */
  long number() {
    return number;
  }

  @Override
  public UrbiObject cloned() {
    return create(this, Finalization.of(world()));
  }

  /**
   * Nothing but the finalizers of Java hands over the object itself once nobody refers to it;
   * references and cleaners must do without it, and with it go the slots.
   */
  @Override
  @SuppressWarnings({"deprecation", "removal", "Finalize"})
  protected void finalize() {
    if (finalization != null) {
      finalization.reclaimed(this);
    }
  }
}
