package org.urbi.kernel.node;

import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code call}. */
public final class CallMessageNode extends Node {
  public CallMessageNode(Span span) {
    super(span);
  }

  @Override
  public UrbiObject execute(Frame frame) {
    return CallMessages.of(frame);
  }
}
