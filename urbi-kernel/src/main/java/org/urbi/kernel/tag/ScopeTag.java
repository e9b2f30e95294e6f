package org.urbi.kernel.tag;

import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Variables;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * A scope whose code asks for {@code scopeTag}: a tag which is stopped when the scope is left,
 * however it is (manual, "Scope tags").
 */
public final class ScopeTag extends Node {
  private final Variables.Place place;
  private final Node body;

  /**
   * @param place where the tag is kept for the code of the scope
   */
  public ScopeTag(Span span, Variables.Place place, Node body) {
    super(span);
    this.place = place;
    this.body = body;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    UrbiTag tag = (UrbiTag) frame.interpreter().prototypes().tag.cloned();
    place.declare(frame, tag);
    try {
      return body.execute(frame);
    } finally {
      tag.state().stop(frame.interpreter().values().voidObject);
    }
  }
}
