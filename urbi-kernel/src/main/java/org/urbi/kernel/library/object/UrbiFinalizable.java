package org.urbi.kernel.library.object;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/**
 * An object whose {@code finalize} is called when it is no longer referenced (manual,
 * "Finalizable").
 *
 * <p>This class is that of the prototype, which is never reclaimed, and has no finalizer of Java:
 * that would keep a kernel that nobody uses any more, with all its objects, until the garbage
 * collector comes twice.
 */
public sealed class UrbiFinalizable extends UrbiObject {
  private final Finalization finalization;

  private UrbiFinalizable(Shape shape, Finalization finalization) {
    super(shape);
    this.finalization = finalization;
  }

  static UrbiFinalizable prototype(Shape shape, Finalization finalization) {
    return new UrbiFinalizable(shape, finalization);
  }

  /** That of the kernel of this object. */
  public Finalization finalization() {
    return finalization;
  }

  @Override
  public UrbiObject cloned() {
    var made = new Reclaimable(cloneShape(), finalization);
    finalization.add(made);
    return made;
  }

  /** What the kernel is told of when it is reclaimed. */
  static final class Reclaimable extends UrbiFinalizable {
    private final long number;
    private final @Nullable UrbiObject maker;

    private Reclaimable(Shape shape, Finalization finalization) {
      super(shape, finalization);
      number = finalization.nextNumber();
      maker = finalization.running().lobby();
    }

    /** The lobby whose code has made it; null if no code has. */
    @Nullable UrbiObject maker() {
      return maker;
    }

    /** Objects are numbered in the order in which they were made. */
    long number() {
      return number;
    }

    /**
     * Only a Java finalizer gets the unreferenced object itself with its slots; references and
     * cleaners do not.
     */
    @Override
    // See above: what takes its place in Java does not do this.
    @SuppressWarnings({"deprecation", "removal", "Finalize"})
    protected void finalize() {
      finalization().reclaimed(this);
    }
  }
}
