package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Located;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Source;
import org.urbi.lang.source.Span;

/** A node of executable code. */
public abstract class Node implements Located {
  private static final Span NOWHERE =
      new Span(new Source("", 1, new Source.Line(0, null, 1)), 0, 0);

  private final Span span;

  protected Node(Span span) {
    this.span = span;
  }

  /** A node that does not stand for source text. */
  protected Node() {
    this(NOWHERE);
  }

  /** Whether it is a piece of a source text. */
  public final boolean isWritten() {
    return span != NOWHERE;
  }

  /** Where it was written. */
  @Override
  public final Span span() {
    return span;
  }

  /** Tells the code that it is that of a function or of the top level. */
  public final void standsIn() {
    standsIn(null);
  }

  /**
   * Tells the code that it stands in that of a function, of the top level or of a loop, and that
   * nothing between them handles exceptions.
   *
   * @param loop the loop, or null
   */
  void standsIn(@Nullable TurnCount loop) {}

  /** Executes the code and returns its value, which may be void. */
  public abstract UrbiObject execute(Frame frame);

  /** Executes the code as a condition. */
  public boolean test(Frame frame) {
    return Truth.of(frame, execute(frame));
  }
}
