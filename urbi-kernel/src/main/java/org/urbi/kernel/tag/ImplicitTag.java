package org.urbi.kernel.tag;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * The tag of {@code name: code} where that name is unknown: it is created among the global tags;
 * that of code which may not do everything, in its lobby, so that nobody gets into its hands by
 * using the same name. The tag of {@code a.b: code} is created as a child of the tag {@code a}
 * (manual, "Tag").
 */
public final class ImplicitTag extends Node {
  private final @Nullable Node target;
  private final Symbol name;
  private final Node tag;

  /**
   * @param target the parent tag, in which the name is looked up and created if needed; null for a
   *     plain name
   * @param tag the tag as a normal expression, used if it can be evaluated
   */
  public ImplicitTag(
      Span span, Interpreter interpreter, @Nullable Node target, String name, Node tag) {
    super(span);
    this.target = target;
    this.name = interpreter.world().symbol(name);
    this.tag = tag;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    if (target == null) {
      return frame.self().locate(name) == null ? unknown(frame) : tag.execute(frame);
    }
    UrbiObject owner = target.execute(frame);
    if (owner.locate(name) == null && owner instanceof UrbiTag above) {
      PermissionCheck.checkChange(frame, "setSlot", above);
      UrbiTag made = (UrbiTag) above.cloned();
      made.addSlot(
          frame.interpreter().world().symbol("name"),
          frame.interpreter().values().string(name.name()));
      above.addSlot(name, made);
      return made;
    }
    try {
      return frame.interpreter().send(frame, owner, name.name());
    } catch (UrbiException e) {
      throw frame.located(e, span());
    }
  }

  /** The tag of a name that {@code this} does not know. */
  private UrbiObject unknown(Frame frame) {
    UrbiObject place =
        frame.job().isOwner() ? frame.interpreter().prototypes().tags : frame.job().lobby();
    UrbiObject known = place.localSlot(name);
    if (known != null) {
      return known;
    }
    UrbiTag made = UrbiTag.named(frame.interpreter(), name.name());
    PermissionCheck.claim(frame, made);
    place.addSlot(name, made);
    return made;
  }
}
