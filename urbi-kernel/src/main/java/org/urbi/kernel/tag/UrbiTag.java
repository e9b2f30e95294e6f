package org.urbi.kernel.tag;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A tag (manual, "Tag"): labels code in order to control it. */
public class UrbiTag extends UrbiObject {
  private final TagState state;
  private @Nullable UrbiTag parent;
  private double priority;
  private @Nullable UrbiEvent enter;
  private @Nullable UrbiEvent leave;

  // The state refers to this tag, so that it can be found from a scope.
  @SuppressWarnings("this-escape")
  public UrbiTag(Shape shape) {
    super(shape);
    this.state = new TagState(this);
  }

  /**
   * A clone of a tag type is a new tag of that type; a clone of a tag is its child, and belongs to
   * the same lobby.
   */
  @Override
  public UrbiObject cloned() {
    UrbiTag clone = new UrbiTag(cloneShape());
    if (localSlot(world().symbol("type")) == null) {
      clone.parent = this;
      clone.takeOwnerOf(this);
    }
    return clone;
  }

  /** A new tag with that name. */
  public static UrbiTag named(Interpreter interpreter, String name) {
    UrbiTag tag = (UrbiTag) interpreter.prototypes().tag.cloned();
    tag.addSlot(interpreter.world().symbol("name"), interpreter.values().string(name));
    return tag;
  }

  /**
   * Code has entered and is about to be executed. Subclasses such as Mutex and Timeout act here.
   */
  protected void entering(Frame frame) {}

  /** Code that has {@linkplain #entering entered} leaves, for whatever reason. */
  protected void left(Frame frame) {}

  /** The value of code that the tag has stopped. */
  protected UrbiObject stopped(Frame frame, UrbiObject value) {
    return value;
  }

  public final TagState state() {
    return state;
  }

  /** The parent tag, or null: operations on the parent apply to this tag, too. */
  public @Nullable UrbiTag parent() {
    return parent;
  }

  /**
   * The priority: while code under the tag can run, code of a lower priority does not. Initially 0.
   */
  public double priority() {
    return priority;
  }

  public void setPriority(double value) {
    priority = value;
  }

  /** The event emitted when code enters; null until somebody asks for it. */
  public @Nullable UrbiEvent enterEvent() {
    return enter;
  }

  /** The event emitted when code leaves; null until somebody asks for it. */
  public @Nullable UrbiEvent leaveEvent() {
    return leave;
  }

  public void setEnterEvent(UrbiEvent event) {
    enter = event;
  }

  public void setLeaveEvent(UrbiEvent event) {
    leave = event;
  }
}
