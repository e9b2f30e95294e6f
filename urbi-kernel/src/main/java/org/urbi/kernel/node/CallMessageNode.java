package org.urbi.kernel.node;

import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code call} outside of functions; in a function, the call message is a variable. */
public final class CallMessageNode extends Node {
  public CallMessageNode(Span span) {
    super(span);
  }

  @Override
  public UrbiObject execute(Frame frame) {
    return frame.interpreter.callMessages().of(frame);
  }

  /** The body of a function that asks for its call message: one for each call. */
  public static final class Declared extends Node {
    private final Node body;
    private final Variables.Place place;

    public Declared(Node body, Variables.Place place) {
      super(body.span());
      this.body = body;
      this.place = place;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      place.declare(frame, frame.interpreter.callMessages().of(frame));
      return body.execute(frame);
    }
  }
}
