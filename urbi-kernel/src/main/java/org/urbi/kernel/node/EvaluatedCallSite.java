package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** A call of a lazy function from Java: its arguments are values already. */
final class EvaluatedCallSite implements CallSite {
  private final CallSite site;
  private final Node[] arguments;

  EvaluatedCallSite(CallSite site, UrbiObject[] values) {
    this.site = site;
    this.arguments = new Node[values.length];
    for (int i = 0; i < values.length; i++) {
      UrbiObject value = values[i];
      arguments[i] =
          new Node() {
            @Override
            public UrbiObject execute(Frame frame) {
              return value;
            }
          };
    }
  }

  @Override
  public String calledName() {
    return site.calledName();
  }

  @Override
  public @Nullable Span calledSpan() {
    return site.calledSpan();
  }

  @Override
  public boolean isNamed() {
    return site.isNamed();
  }

  @Override
  public Node[] argumentNodes() {
    return arguments;
  }
}
