package org.urbi.kernel.library.lobby;

import java.util.Map;
import java.util.WeakHashMap;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.tag.UrbiTag;

/** A category of messages for the administrator; a tag, to indent them (manual, "Logger"). */
final class UrbiLogger extends UrbiTag {
  private static final int WIDTH = 23;

  /** How deep messages are indented at most: more would hide them. */
  private static final int DEEPEST = 32;

  /** The indentation of each lobby, shared by all the loggers of a kernel. */
  static final class Depth {
    private final Map<UrbiObject, Integer> values = new WeakHashMap<>();

    private int of(UrbiObject lobby) {
      return values.getOrDefault(lobby, 0);
    }

    private void set(UrbiObject lobby, int value) {
      if (value == 0) {
        values.remove(lobby);
      } else {
        values.put(lobby, value);
      }
    }
  }

  private final Depth depth;
  private String category;
  private @Nullable LogLevel level;

  UrbiLogger(Shape shape, Depth depth, String category, @Nullable LogLevel level) {
    super(shape);
    this.depth = depth;
    this.category = category;
    this.level = level;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiLogger(cloneShape(), depth, category, level);
  }

  String category() {
    return category;
  }

  void setCategory(String name) {
    category = name;
  }

  /** The level of what is sent with {@code <<}; null when there is none. */
  @Nullable LogLevel level() {
    return level;
  }

  void setLevel(LogLevel other) {
    level = other;
  }

  /** A logger of that category for messages of that level. */
  UrbiLogger at(LogLevel other, String name) {
    return new UrbiLogger(world().prototype("Logger").cloneShape(), depth, name, other);
  }

  /** A line of the log: the category in the middle of brackets, the message of a lobby. */
  String line(UrbiObject lobby, String name, String message) {
    int room = Math.max(0, WIDTH - name.length());
    int before = room / 2;
    return "["
        + " ".repeat(before)
        + name
        + " ".repeat(room - before)
        + "] "
        + "  ".repeat(Math.min(depth.of(lobby), DEEPEST))
        + message;
  }

  /** Indents what that lobby reports. */
  void indent(UrbiObject lobby) {
    depth.set(lobby, depth.of(lobby) + 1);
  }

  /** Ends an {@link #indent}, if there is one: code may ask for it too often. */
  void unindent(UrbiObject lobby) {
    depth.set(lobby, Math.max(0, depth.of(lobby) - 1));
  }

  @Override
  protected void entering(Frame frame) {
    frame.interpreter().send(frame, this, "onEnter");
  }

  @Override
  protected void left(Frame frame) {
    frame.interpreter().send(frame, this, "onLeave");
  }
}
