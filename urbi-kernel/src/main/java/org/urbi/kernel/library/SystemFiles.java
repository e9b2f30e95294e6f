package org.urbi.kernel.library;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** Source files and where they are looked for (manual, "System" and "Environment Variables"). */
@UrbiTypePart("System")
final class SystemFiles {
  private SystemFiles() {}

  @Builtin(doc = "Evaluates a source file found in the search path, and returns its last value.")
  static UrbiObject load(
      Frame frame, CallSite site, UrbiObject self, UrbiObject file, @Optional UrbiObject target) {
    String name = frame.interpreter().asString(frame, file);
    return evaluate(frame, site, self, found(frame, name), target);
  }

  @Builtin(doc = "Evaluates a source file, and returns its last value.")
  static UrbiObject loadFile(
      Frame frame, CallSite site, UrbiObject self, UrbiObject file, @Optional UrbiObject target) {
    String name = frame.interpreter().asString(frame, file);
    Path path = path(frame, name);
    if (!Files.isRegularFile(path)) {
      throw notFound(frame, name);
    }
    return evaluate(frame, site, self, path, target);
  }

  @Builtin(doc = "Evaluates a source file if it is found, and says so on a channel.")
  static UrbiObject maybeLoad(
      Frame frame, CallSite site, UrbiObject self, UrbiObject file, @Optional UrbiObject channel) {
    String name = frame.interpreter().asString(frame, file);
    Path path = search(frame, name);
    if (path == null) {
      return frame.interpreter().values().voidObject;
    }
    if (channel != null) {
      frame
          .interpreter()
          .send(frame, channel, "<<", frame.interpreter().values().string("loading file: " + path));
    }
    return evaluate(frame, site, self, path, null);
  }

  @Builtin(doc = "The path of a source file, looked for in the search path.")
  static UrbiObject searchFile(Frame frame, UrbiObject self, UrbiObject file) {
    String name = frame.interpreter().asString(frame, file);
    return urbiPath(frame, found(frame, name));
  }

  @Builtin(doc = "The folders where source files are looked for.")
  static List<UrbiObject> searchPath(Frame frame, UrbiObject self) {
    List<UrbiObject> folders = new ArrayList<>();
    for (Path folder : KernelControl.of(frame).searchPath()) {
      folders.add(urbiPath(frame, folder));
    }
    return folders;
  }

  private static UrbiObject urbiPath(Frame frame, Path path) {
    return frame
        .interpreter()
        .send(
            frame,
            frame.interpreter().world().prototype("Path"),
            "new",
            frame.interpreter().values().string(path.toString()));
  }

  private static Path path(Frame frame, String name) {
    try {
      return Path.of(name);
    } catch (InvalidPathException e) {
      throw notFound(frame, name);
    }
  }

  private static Path found(Frame frame, String name) {
    Path path = search(frame, name);
    if (path == null) {
      throw notFound(frame, name);
    }
    return path;
  }

  private static Path search(Frame frame, String name) {
    Path path = path(frame, name);
    if (path.isAbsolute()) {
      return Files.isRegularFile(path) ? path : null;
    }
    for (Path folder : KernelControl.of(frame).searchPath()) {
      Path candidate = folder.resolve(path);
      if (Files.isRegularFile(candidate)) {
        return candidate;
      }
    }
    return Files.isRegularFile(path) ? path : null;
  }

  private static RuntimeException notFound(Frame frame, String name) {
    return frame
        .interpreter()
        .errors()
        .of("FileNotFound", "file not found: " + name)
        .with("name", name)
        .build();
  }

  private static UrbiObject evaluate(
      Frame frame, CallSite site, UrbiObject self, Path path, UrbiObject target) {
    String text;
    try {
      text = Files.readString(path, StandardCharsets.ISO_8859_1);
    } catch (IOException e) {
      throw frame.interpreter().errors().primitive(site.calledName(), "cannot read file: " + path);
    }
    return Evaluation.eval(frame, site, target == null ? self : target, text, path.toString());
  }
}
