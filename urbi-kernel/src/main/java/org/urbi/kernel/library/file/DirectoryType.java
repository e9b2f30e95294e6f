package org.urbi.kernel.library.file;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.World;
import org.urbi.kernel.outside.Disk;
import org.urbi.kernel.outside.Outside;
import org.urbi.lang.print.StringEscape;

/** Directories (manual, "Directory"). */
@UrbiType(value = "Directory", doc = "A directory of the file system.", needs = Permission.USER)
final class DirectoryType {
  /** A directory in which there is more is listed on a thread of its own. */
  private static final int FEW_NAMES = 1000;

  private final FileAccess files;
  private final DirectoryWatches watches;

  DirectoryType(FileAccess files, Outside outside) {
    this.files = files;
    this.watches = new DirectoryWatches(outside);
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiDirectory(world.values().object.cloneShape(), null);
  }

  UrbiDirectory directory(Frame frame, UrbiPath path) {
    UrbiObject prototype = frame.interpreter().world().prototype("Directory");
    UrbiDirectory made = new UrbiDirectory(prototype.cloneShape(), path);
    DirectoryEvents.add(frame, watches, made);
    return made;
  }

  /** The target, which must not be the prototype itself. */
  private static UrbiPath path(Frame frame, CallSite site, UrbiDirectory self) {
    if (self.path() == null) {
      throw frame.error(site, Problem.NOT_A_DIRECTORY);
    }
    return self.path();
  }

  /** Nothing of that name may exist. */
  private void checkAbsent(Frame frame, CallSite site, UrbiPath path) {
    if (files.isDirectory(frame, site, path)) {
      throw FileAccess.error(frame, site, Problem.DIRECTORY_EXISTS, path);
    }
    if (files.hasEntry(frame, site, path)) {
      throw FileAccess.error(frame, site, Problem.FILE_EXISTS, path);
    }
  }

  // ------------------------------------------------------------------ construction

  @Builtin(doc = "Makes it the directory of that name, which must exist.")
  UrbiDirectory init(Frame frame, CallSite site, UrbiDirectory self, UrbiObject name) {
    FileAccess.checkNotPrototype(frame, site, self, "Directory");
    self.setPath(files.existingDirectory(frame, site, 1, name));
    DirectoryEvents.add(frame, watches, self);
    return self;
  }

  @Builtin(doc = "Creates the directory of that name, which must not exist.")
  UrbiDirectory create(Frame frame, CallSite site, UrbiObject self, UrbiObject name) {
    UrbiPath path = FileAccess.path(frame, site, 1, name);
    checkAbsent(frame, site, path);
    FileAccess.change(frame, site, path, () -> files.disk().createDirectory(path.file()));
    return directory(frame, path);
  }

  @Builtin(doc = "The directory of that name; it and those around it are made if missing.")
  UrbiDirectory createAll(Frame frame, CallSite site, UrbiObject self, UrbiObject name) {
    UrbiPath path = FileAccess.path(frame, site, 1, name);
    FileAccess.change(frame, site, path, () -> files.disk().createDirectories(path.file()));
    return directory(frame, path);
  }

  @Builtin(doc = "The working directory.")
  UrbiDirectory current(Frame frame, UrbiObject self) {
    return directory(frame, FileAccess.anyPath(frame).sibling("."));
  }

  // ------------------------------------------------------------------ the name

  @Builtin(doc = "The path of the directory.")
  static UrbiPath asPath(Frame frame, CallSite site, UrbiDirectory self) {
    return path(frame, site, self);
  }

  @Builtin(doc = "The directory, to be shown.")
  static String asPrintable(UrbiDirectory self) {
    return self.path() == null ? "Directory" : "Directory(" + StringEscape.quote(self.text()) + ")";
  }

  @Builtin(doc = "The name of the directory.")
  static String asString(UrbiDirectory self) {
    return self.path() == null ? "Directory" : self.text();
  }

  @Builtin(doc = "The name of the directory without the one it is in.")
  static String basename(Frame frame, CallSite site, UrbiDirectory self) {
    return FileAccess.basename(path(frame, site, self));
  }

  @Builtin(doc = "The directory it is in.")
  UrbiDirectory parent(Frame frame, CallSite site, UrbiDirectory self) {
    UrbiPath path = path(frame, site, self);
    String name = FileAccess.basename(path);
    return directory(
        frame,
        name.equals(".")
            ? path.sibling("..")
            : name.equals("..") ? path.sibling(path.text() + "/..") : PathType.dirname(path));
  }

  @Builtin(value = "/", doc = "The File or the Directory of that name in it.")
  UrbiObject divide(Frame frame, CallSite site, UrbiDirectory self, String str) {
    FileAccess.checkName(frame, site, str);
    UrbiPath inside = FileAccess.inside(path(frame, site, self), str);
    if (files.isDirectory(frame, site, inside)) {
      return directory(frame, inside);
    }
    if (!files.exists(frame, site, inside)) {
      throw FileAccess.error(frame, site, Problem.NO_SUCH_FILE, inside);
    }
    return FileType.file(frame, inside);
  }

  // ------------------------------------------------------------------ the content

  private List<String> names(Frame frame, CallSite site, UrbiDirectory self) {
    UrbiPath path = path(frame, site, self);
    Disk disk = files.disk();
    List<Path> found =
        FileAccess.quickly(frame, site, path, () -> disk.names(path.file(), FEW_NAMES));
    if (found.size() == FEW_NAMES) {
      found = files.slowly(frame, site, path, () -> disk.names(path.file(), Integer.MAX_VALUE));
    }
    List<String> names = new ArrayList<>(found.size());
    for (Path name : found) {
      frame.job().worked(Steps.OBJECT);
      names.add(UrbiPath.encoded(name));
    }
    names.sort((one, other) -> {
      frame.job().worked(Steps.OBJECT);
      return one.compareTo(other);
    });
    return names;
  }

  @Builtin(doc = "The paths of what is in it, which begin with its own.")
  List<UrbiPath> asList(Frame frame, CallSite site, UrbiDirectory self) {
    UrbiPath path = path(frame, site, self);
    List<UrbiPath> paths = new ArrayList<>();
    for (String name : names(frame, site, self)) {
      frame.job().worked(Steps.OBJECT);
      paths.add(path.sibling(path.text() + "/" + name));
    }
    return paths;
  }

  @Builtin(doc = "The names of what is in it.")
  List<UrbiString> content(Frame frame, CallSite site, UrbiDirectory self) {
    return names(frame, site, self).stream().map(frame.interpreter().values()::string).toList();
  }

  @Builtin(doc = "Whether there is nothing in it.")
  boolean empty(Frame frame, CallSite site, UrbiDirectory self) {
    UrbiPath path = path(frame, site, self);
    return FileAccess.quickly(frame, site, path, () -> files.disk().isEmpty(path.file()));
  }

  @Builtin(doc = "Whether there is still such a directory.")
  boolean exists(Frame frame, CallSite site, UrbiDirectory self) {
    return files.isDirectory(frame, site, path(frame, site, self));
  }

  @Builtin(doc = "The date at which the directory was last modified.")
  UrbiObject lastModifiedDate(Frame frame, CallSite site, UrbiDirectory self) {
    return files.lastModified(frame, site, path(frame, site, self));
  }

  @Builtin(doc = "The sizes of all files in it and its directories together, in bytes.")
  double size(Frame frame, CallSite site, UrbiDirectory self) {
    UrbiPath path = path(frame, site, self);
    return files.slowly(frame, site, path, () -> (double) files.disk().treeSize(path.file()));
  }

  // ------------------------------------------------------------------ changes

  @Builtin(value = "<<", doc = "Copies a File or a Directory into it.")
  UrbiDirectory add(Frame frame, CallSite site, UrbiDirectory self, UrbiObject entity) {
    switch (entity) {
      case UrbiFile file -> new FileType(files).copyInto(frame, site, file, self);
      case UrbiDirectory directory -> copyInto(frame, site, directory, self);
      default -> throw Arguments.type(frame, site, 1, entity, "File");
    }
    return self;
  }

  @Builtin(doc = "Copies it and all that is in it to a new directory, and returns that.")
  UrbiDirectory copy(Frame frame, CallSite site, UrbiDirectory self, UrbiObject dirname) {
    return copied(frame, site, self, FileAccess.path(frame, site, 1, dirname));
  }

  @Builtin(doc = "Copies it and all that is in it into a directory, and returns the copy.")
  UrbiDirectory copyInto(Frame frame, CallSite site, UrbiDirectory self, UrbiObject dirname) {
    return copied(frame, site, self, insideOf(frame, site, self, dirname));
  }

  private UrbiPath insideOf(Frame frame, CallSite site, UrbiDirectory self, UrbiObject dirname) {
    UrbiPath directory = files.existingDirectory(frame, site, 1, dirname);
    return FileAccess.inside(directory, FileAccess.basename(path(frame, site, self)));
  }

  private UrbiDirectory copied(Frame frame, CallSite site, UrbiDirectory self, UrbiPath to) {
    checkAbsent(frame, site, to);
    files.checkPlace(frame, site, to);
    UrbiPath from = path(frame, site, self);
    files.changeSlowly(frame, site, from, () -> files.disk().copyTree(from.file(), to.file()));
    return directory(frame, to);
  }

  @Builtin(doc = "Moves it into a directory.")
  UrbiDirectory moveInto(Frame frame, CallSite site, UrbiDirectory self, UrbiObject dirname) {
    return moved(frame, site, self, insideOf(frame, site, self, dirname));
  }

  @Builtin(doc = "Gives it another name, which may be in another directory.")
  UrbiDirectory rename(Frame frame, CallSite site, UrbiDirectory self, UrbiObject name) {
    return moved(frame, site, self, FileAccess.path(frame, site, 1, name));
  }

  private UrbiDirectory moved(Frame frame, CallSite site, UrbiDirectory self, UrbiPath to) {
    checkAbsent(frame, site, to);
    files.checkPlace(frame, site, to);
    UrbiPath from = path(frame, site, self);
    files.changeSlowly(frame, site, from, () -> files.disk().move(from.file(), to.file()));
    self.setPath(to);
    return self;
  }

  @Builtin(doc = "Removes all that is in it.")
  void clear(Frame frame, CallSite site, UrbiDirectory self) {
    UrbiPath path = path(frame, site, self);
    files.changeSlowly(frame, site, path, () -> files.disk().clear(path.file()));
  }

  @Builtin(doc = "Removes it, if there is nothing in it.")
  void remove(Frame frame, CallSite site, UrbiDirectory self) {
    UrbiPath path = files.existingDirectory(frame, site, 0, self);
    files.changeSlowly(frame, site, path, () -> files.disk().delete(path.file()));
  }

  @Builtin(doc = "Removes it and all that is in it.")
  void removeAll(Frame frame, CallSite site, UrbiDirectory self) {
    UrbiPath path = path(frame, site, self);
    files.changeSlowly(frame, site, path, () -> files.disk().removeTree(path.file()));
  }
}
