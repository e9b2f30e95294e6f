package org.urbi.kernel.library.file;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;

/** The name of a file or directory (manual, "Path"). */
public final class UrbiPath extends UrbiObject {
  private final WorkingDirectory working;
  private String text;

  UrbiPath(Shape shape, String text, WorkingDirectory working) {
    super(shape);
    this.working = working;
    this.text = text;
  }

  /** The path as urbiscript shows it. */
  public String text() {
    return text;
  }

  void setText(String other) {
    text = simplified(other);
  }

  public WorkingDirectory working() {
    return working;
  }

  public boolean isAbsolute() {
    return text.startsWith("/");
  }

  /** The names in the path. */
  public List<String> names() {
    List<String> names = new ArrayList<>(List.of(text.split("/")));
    names.removeIf(String::isEmpty);
    return names;
  }

  /** The file in the file system; relative paths start from the working directory. */
  public Path file() {
    return working.path().resolve(Utf8Text.toJava(text)).normalize();
  }

  /** Another path of the same kernel. */
  public UrbiPath sibling(String other) {
    return new UrbiPath(shape().world().prototype("Path").cloneShape(), simplified(other), working);
  }

  /** Another object for the same path. */
  public UrbiPath same() {
    return new UrbiPath(shape(), text, working);
  }

  /** The path without what makes no difference: {@code .}, and slashes in a row. */
  static String simplified(String path) {
    if (isSimple(path)) {
      return path;
    }
    List<String> names = new ArrayList<>();
    for (String name : path.split("/")) {
      if (!name.isEmpty() && !name.equals(".")) {
        names.add(name);
      }
    }
    String joined = String.join("/", names);
    return path.startsWith("/") ? "/" + joined : joined.isEmpty() ? "." : joined;
  }

  private static boolean isSimple(String path) {
    if (path.length() <= 1) {
      return !path.isEmpty();
    }
    return !path.endsWith("/")
        && !path.contains("//")
        && !path.startsWith("./")
        && !path.contains("/./")
        && !path.endsWith("/.");
  }

  /** A name of the file system as a string of urbiscript. */
  public static String encoded(Path path) {
    return Utf8Text.toUrbi(path.toString());
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiPath(cloneShape(), text, working);
  }
}
