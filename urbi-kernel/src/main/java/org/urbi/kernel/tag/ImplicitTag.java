package org.urbi.kernel.tag;

import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * The tag of {@code name: code} where no such name is known: it is made, among the global tags
 * (manual, "Tag").
 */
public final class ImplicitTag extends Node {
  private final Node target;
  private final Symbol name;
  private final Node tag;

  /**
   * @param target null for a plain name
   * @param tag the expression as it would be evaluated anyway
   */
  public ImplicitTag(Span span, Interpreter interpreter, Node target, String name, Node tag) {
    super(span);
    this.target = target;
    this.name = interpreter.world().symbol(name);
    this.tag = tag;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    if (target == null && frame.self().locate(name) == null) {
      Interpreter interpreter = frame.interpreter();
      UrbiTag made = UrbiTag.named(interpreter, name.name());
      interpreter.prototypes().tags.addSlot(name, made);
      return made;
    }
    return tag.execute(frame);
  }
}
