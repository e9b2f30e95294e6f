package org.urbi.ros.message;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The name of a type, the same for both versions of ROS: what one calls {@code std_msgs/String} is
 * {@code std_msgs/msg/String} to the other.
 *
 * @param pack the package
 * @param name the name of the file without its ending, or what is derived from it
 */
public record TypeName(String pack, Kind kind, String name) implements Comparable<TypeName> {
  /** What a type describes: each has a folder of its own in a package. */
  public enum Kind {
    MESSAGE("msg"),
    SERVICE("srv"),
    ACTION("action");

    private final String folder;

    Kind(String folder) {
      this.folder = folder;
    }

    /** The folder in a package, and the ending of the files in it. */
    public String folder() {
      return folder;
    }

    private static Kind of(String folder) {
      for (Kind kind : values()) {
        if (kind.folder.equals(folder)) {
          return kind;
        }
      }
      throw new AssertionError(folder);
    }
  }

  private static final Pattern FORM =
      Pattern.compile("([a-zA-Z]\\w*)/(?:(msg|srv|action)/)?([a-zA-Z]\\w*)");

  /** The name of a message. */
  public static TypeName message(String pack, String name) {
    return new TypeName(pack, Kind.MESSAGE, name);
  }

  /**
   * Reads {@code package/Name} or {@code package/msg/Name}.
   *
   * @param kind of what it is the name if it does not say so
   * @throws DefinitionException if it has another form
   */
  public static TypeName parse(String text, Kind kind) {
    Matcher form = FORM.matcher(text.strip());
    if (!form.matches()) {
      throw new DefinitionException(
          "the name of a type is package/Name, as std_msgs/String, not '" + text + "'");
    }
    String folder = form.group(2);
    return new TypeName(form.group(1), folder == null ? kind : Kind.of(folder), form.group(3));
  }

  /** The type that ROS derives from this one: {@code Trigger_Request}. */
  public TypeName derived(String suffix) {
    return new TypeName(pack, kind, name + suffix);
  }

  /** As the users of a version write it. */
  public String in(Dialect dialect) {
    return switch (dialect) {
      case ROS_1 -> pack + "/" + name;
      case ROS_2 -> toString();
    };
  }

  @Override
  public int compareTo(TypeName other) {
    return toString().compareTo(other.toString());
  }

  /** {@code package/msg/Name}. */
  @Override
  public String toString() {
    return pack + "/" + kind.folder() + "/" + name;
  }
}
