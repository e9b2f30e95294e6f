package org.urbi.kernel.library.system;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.code.LoadedFiles;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.library.file.UrbiPath;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;

/** Source files and where they are looked for (manual, "System" and "Environment Variables"). */
@UrbiTypePart(value = "System", needs = Permission.USER)
final class SystemFiles {
  private final FileAccess files;
  private final SearchPath searchPath;
  private final LoadedFiles loadedFiles;

  SystemFiles(FileAccess files, SearchPath searchPath, LoadedFiles loadedFiles) {
    this.files = files;
    this.searchPath = searchPath;
    this.loadedFiles = loadedFiles;
  }

  @Builtin(
      doc =
          "Evaluates a source file found in the search path, in the working directory or beside the"
              + " file that loads it, and returns its last value.")
  UrbiObject load(
      Frame frame,
      CallSite site,
      UrbiObject self,
      UrbiObject file,
      @Optional @Nullable UrbiObject target) {
    String name = frame.interpreter().asString(frame, file);
    Path path = search(frame, site, name);
    if (path == null) {
      throw missing(frame, name).with("routine", "load").build();
    }
    return evaluate(frame, site, self, path, target);
  }

  @Builtin(doc = "Evaluates a source file, and returns its last value.")
  UrbiObject loadFile(
      Frame frame,
      CallSite site,
      UrbiObject self,
      UrbiObject file,
      @Optional @Nullable UrbiObject target) {
    String name = frame.interpreter().asString(frame, file);
    Path path = workingDirectory(frame).resolve(path(frame, name));
    if (!isFile(frame, site, path)) {
      throw notFound(frame, name);
    }
    return evaluate(frame, site, self, path, target);
  }

  @Builtin(doc = "Evaluates a source file if it is found, and says so on a channel.")
  UrbiObject maybeLoad(
      Frame frame,
      CallSite site,
      UrbiObject self,
      UrbiObject file,
      @Optional @Nullable UrbiObject channel) {
    String name = frame.interpreter().asString(frame, file);
    Path path = search(frame, site, name);
    if (path == null) {
      return frame.interpreter().values().voidObject;
    }
    if (channel != null) {
      frame
          .interpreter()
          .send(
              frame,
              channel,
              "<<",
              frame.interpreter().values().string(Problem.LOADING.text(path)));
    }
    return evaluate(frame, site, self, path, null);
  }

  @Builtin(doc = "The path of a source file, looked for in the search path.")
  UrbiObject searchFile(Frame frame, CallSite site, UrbiObject self, UrbiObject file) {
    String name = frame.interpreter().asString(frame, file);
    return urbiPath(frame, found(frame, site, name));
  }

  @Builtin(doc = "The folders where source files are looked for.")
  List<UrbiObject> searchPath(Frame frame, UrbiObject self) {
    List<UrbiObject> folders = new ArrayList<>();
    for (Path folder : searchPath.folders()) {
      folders.add(urbiPath(frame, folder));
    }
    return folders;
  }

  @Builtin(doc = "Evaluates a source file found in the search path, unless that was done before.")
  void requireFile(
      Frame frame,
      CallSite site,
      UrbiObject self,
      UrbiObject file,
      @Optional @Nullable UrbiObject target) {
    Path path = found(frame, site, frame.interpreter().asString(frame, file));
    if (!loadedFiles.contains(frame.job(), key(frame, path))) {
      evaluate(frame, site, self, path, target);
    }
  }

  @Builtin(doc = "The folder with the source files of the library, a Path; nil when there is none.")
  UrbiObject urbiShareDir(Frame frame, UrbiObject self) {
    Path library = searchPath.library();
    return library == null ? frame.interpreter().values().nil : urbiPath(frame, library);
  }

  @Builtin(doc = "The folder in which Urbi is installed; empty when that is not known.")
  String urbiRoot(Frame frame, UrbiObject self) {
    Path library = searchPath.library();
    Path root = library == null ? null : library.toAbsolutePath().normalize().getParent();
    return root == null ? "" : UrbiPath.encoded(root);
  }

  @Builtin(doc = "The source files whose calls backtraces do not show.")
  List<UrbiObject> systemFiles(Frame frame, UrbiObject self) {
    return loadedFiles.systemFiles().stream()
        .map(name -> (UrbiObject) frame.interpreter().values().string(name))
        .toList();
  }

  @Builtin(
      value = {"systemFiles"},
      setter = true,
      doc = "Sets which source files these are.",
      needs = Permission.OWNER)
  void assignSystemFiles(Frame frame, UrbiObject self, UrbiList files) {
    loadedFiles.setSystemFiles(
        files.elements().stream().map(file -> frame.interpreter().asString(frame, file)).toList());
  }

  @Builtin(doc = "Sets which source files these are.", needs = Permission.OWNER)
  void setSystemFiles(Frame frame, UrbiObject self, UrbiList files) {
    assignSystemFiles(frame, self, files);
  }

  @Builtin(doc = "Adds a source file to them.", needs = Permission.OWNER)
  void addSystemFile(Frame frame, UrbiObject self, UrbiObject file) {
    loadedFiles.noteSystemFile(frame.interpreter().asString(frame, file));
  }

  private boolean isFile(Frame frame, CallSite site, Path path) {
    UrbiPath shown = FileAccess.anyPath(frame).sibling(UrbiPath.encoded(path));
    return FileAccess.quickly(frame, site, shown, () -> files.disk().isRegularFile(path));
  }

  private static UrbiObject urbiPath(Frame frame, Path path) {
    return FileAccess.anyPath(frame).sibling(UrbiPath.encoded(path));
  }

  private static Path workingDirectory(Frame frame) {
    return FileAccess.anyPath(frame).working().path();
  }

  private static Path path(Frame frame, String name) {
    try {
      return Path.of(Utf8Text.toJava(name));
    } catch (InvalidPathException e) {
      throw notFound(frame, name);
    }
  }

  private Path found(Frame frame, CallSite site, String name) {
    Path path = search(frame, site, name);
    if (path == null) {
      throw notFound(frame, name);
    }
    return path;
  }

  private @Nullable Path search(Frame frame, CallSite site, String name) {
    Path path = path(frame, name);
    Path working = workingDirectory(frame);
    if (path.isAbsolute()) {
      return isFile(frame, site, path) ? path : null;
    }
    for (Path folder : searchPath.folders()) {
      Path candidate = working.resolve(folder).normalize().resolve(path);
      try {
        if (files.disk().isRegularFile(candidate)) {
          return candidate;
        }
      } catch (IOException e) {
        // That folder is not for this kernel.
      }
    }
    Path here = working.resolve(path);
    if (isFile(frame, site, here)) {
      return here;
    }
    Path beside = beside(frame, site, path);
    return beside != null && isFile(frame, site, beside) ? beside : null;
  }

  /** A file in the folder of the one in which the call is written; null when that has no name. */
  private @Nullable Path beside(Frame frame, CallSite site, Path path) {
    if (site.calledSpan() == null || site.calledSpan().location().file() == null) {
      return null;
    }
    try {
      Path caller = Path.of(Utf8Text.toJava(site.calledSpan().location().file()));
      return workingDirectory(frame).resolve(caller).resolveSibling(path);
    } catch (InvalidPathException e) {
      // The name is that of a syncline, and none of a file.
      return null;
    }
  }

  /**
   * The name of a file in messages: short when it is the library's, or in the working directory.
   */
  private String shown(Frame frame, Path file) {
    Path library = searchPath.library();
    if (library != null && file.startsWith(library)) {
      String name = UrbiPath.encoded(library.relativize(file));
      loadedFiles.noteSystemFile(name);
      return name;
    }
    Path working = workingDirectory(frame);
    return UrbiPath.encoded(file.startsWith(working) ? working.relativize(file) : file);
  }

  /** By what a file is known, whatever the links that lead there. */
  private Path key(Frame frame, Path file) {
    try {
      return files.disk().real(file);
    } catch (IOException e) {
      return file.toAbsolutePath().normalize();
    }
  }

  private static RuntimeException notFound(Frame frame, String name) {
    return missing(frame, name).build();
  }

  private static Errors.Builder missing(Frame frame, String name) {
    return frame.interpreter().errors().of(Problem.NO_FILE, name).with("name", name);
  }

  private UrbiObject evaluate(
      Frame frame, CallSite site, UrbiObject self, Path path, @Nullable UrbiObject target) {
    Path key = key(frame, path);
    boolean complete = false;
    loadedFiles.begin(frame.job(), key);
    try {
      UrbiPath named = FileAccess.anyPath(frame).sibling(UrbiPath.encoded(path));
      String text =
          new String(files.content(frame, site, named, path), StandardCharsets.ISO_8859_1);
      UrbiObject value =
          Evaluation.eval(frame, site, target == null ? self : target, text, shown(frame, path));
      complete = true;
      return value;
    } finally {
      loadedFiles.end(frame.job(), key, complete);
    }
  }
}
