package org.urbi.kernel.library.file;

import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.library.text.BinaryType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiBinary;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.World;
import org.urbi.lang.print.StringEscape;

/** Files (manual, "File"). */
@UrbiType(value = "File", doc = "A file of the file system.", needs = Permission.USER)
final class FileType {
  private final FileAccess files;

  FileType(FileAccess files) {
    this.files = files;
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiFile(world.values().object.cloneShape(), null);
  }

  static UrbiFile file(Frame frame, UrbiPath path) {
    UrbiObject prototype = frame.interpreter().world().prototype("File");
    return new UrbiFile(prototype.cloneShape(), path);
  }

  /** The target, which must not be the prototype itself. */
  static UrbiPath path(Frame frame, CallSite site, UrbiFile self) {
    if (self.path() == null) {
      throw frame.error(site, Problem.NOT_A_FILE);
    }
    return self.path();
  }

  // ------------------------------------------------------------------ construction

  @Builtin(doc = "Makes it the file of that name, which must exist.")
  UrbiFile init(Frame frame, CallSite site, UrbiFile self, UrbiObject name) {
    FileAccess.checkNotPrototype(frame, site, self, "File");
    UrbiPath path = FileAccess.path(frame, site, 1, name);
    if (files.isDirectory(frame, site, path)) {
      throw FileAccess.error(frame, site, Problem.NOT_A_FILE, path);
    }
    if (!files.exists(frame, site, path)) {
      throw FileAccess.error(frame, site, Problem.FILE_MISSING, path);
    }
    self.setPath(path);
    return self;
  }

  @Builtin(doc = "The file of that name, made if it does not exist, and emptied if it does.")
  UrbiFile create(Frame frame, CallSite site, UrbiObject self, UrbiObject name) {
    UrbiPath path = FileAccess.path(frame, site, 1, name);
    write(frame, site, path, new byte[0]);
    return file(frame, path);
  }

  @Builtin(doc = "Creates the file of that name, with that content.")
  void save(Frame frame, CallSite site, UrbiObject self, UrbiObject name, UrbiObject content) {
    String bytes =
        content instanceof UrbiBinary binary
            ? binary.data()
            : Arguments.text(frame, site, 2, content);
    write(frame, site, FileAccess.path(frame, site, 1, name), Utf8Text.bytes(bytes));
  }

  private void write(Frame frame, CallSite site, UrbiPath path, byte[] bytes) {
    boolean quick =
        bytes.length <= FileAccess.LARGE
            && (files.isRegularFile(frame, site, path) || !files.exists(frame, site, path));
    FileAccess.Change change = () -> files.disk().write(path.file(), bytes);
    if (quick) {
      FileAccess.change(frame, site, path, change);
    } else {
      files.changeSlowly(frame, site, path, change);
    }
  }

  // ------------------------------------------------------------------ the name

  @Builtin(doc = "The path of the file.")
  static UrbiPath asPath(Frame frame, CallSite site, UrbiFile self) {
    return path(frame, site, self);
  }

  @Builtin(doc = "The file, to be shown.")
  static String asPrintable(UrbiFile self) {
    return self.path() == null ? "File" : "File(" + StringEscape.quote(self.text()) + ")";
  }

  @Builtin(doc = "The name of the file.")
  static String asString(UrbiFile self) {
    return self.path() == null ? "File" : self.text();
  }

  @Builtin(doc = "The name of the file without its directory.")
  static String basename(Frame frame, CallSite site, UrbiFile self) {
    return FileAccess.basename(path(frame, site, self));
  }

  // ------------------------------------------------------------------ the content

  private byte[] bytes(Frame frame, CallSite site, UrbiFile self) {
    UrbiPath path = path(frame, site, self);
    return files.content(frame, site, path, path.file());
  }

  @Builtin(doc = "The lines of the file.")
  List<UrbiString> asList(Frame frame, CallSite site, UrbiFile self) {
    String text = Utf8Text.text(bytes(frame, site, self));
    List<UrbiString> lines = new ArrayList<>();
    int from = 0;
    while (from < text.length()) {
      int newline = text.indexOf('\n', from);
      int to = newline < 0 ? text.length() : newline;
      frame.job().worked(Steps.OBJECT + Steps.ofCharacters(to - from));
      int end = to > from && text.charAt(to - 1) == '\r' ? to - 1 : to;
      lines.add(frame.interpreter().values().string(text.substring(from, end)));
      from = to + 1;
    }
    return lines;
  }

  @Builtin(doc = "The content of the file, as a Binary.")
  UrbiObject content(Frame frame, CallSite site, UrbiFile self) {
    return BinaryType.binary(frame, "", Utf8Text.text(bytes(frame, site, self)));
  }

  @Builtin(doc = "The size of the file, in bytes.")
  double size(Frame frame, CallSite site, UrbiFile self) {
    UrbiPath path = path(frame, site, self);
    return FileAccess.quickly(frame, site, path, () -> (double) files.disk().size(path.file()));
  }

  @Builtin(doc = "The date at which the file was last modified.")
  UrbiObject lastModifiedDate(Frame frame, CallSite site, UrbiFile self) {
    return files.lastModified(frame, site, path(frame, site, self));
  }

  // ------------------------------------------------------------------ changes

  @Builtin(doc = "Copies the file to a new one of that name, and returns that.")
  UrbiFile copy(Frame frame, CallSite site, UrbiFile self, UrbiObject filename) {
    return copied(frame, site, self, FileAccess.path(frame, site, 1, filename));
  }

  @Builtin(doc = "Copies the file into a directory, and returns the copy.")
  UrbiFile copyInto(Frame frame, CallSite site, UrbiFile self, UrbiObject dirname) {
    UrbiPath directory = files.existingDirectory(frame, site, 1, dirname);
    String name = FileAccess.basename(path(frame, site, self));
    return copied(frame, site, self, FileAccess.inside(directory, name));
  }

  private UrbiFile copied(Frame frame, CallSite site, UrbiFile self, UrbiPath to) {
    UrbiPath from = path(frame, site, self);
    if (!files.hasEntry(frame, site, from)) {
      throw FileAccess.error(frame, site, Problem.NO_SUCH_FILE, from);
    }
    files.changeSlowly(frame, site, to, () -> files.disk().copy(from.file(), to.file()));
    return file(frame, to);
  }

  @Builtin(doc = "Moves the file into a directory.")
  UrbiFile moveInto(Frame frame, CallSite site, UrbiFile self, UrbiObject dirname) {
    UrbiPath directory = files.existingDirectory(frame, site, 1, dirname);
    String name = FileAccess.basename(path(frame, site, self));
    return moved(frame, site, self, FileAccess.inside(directory, name));
  }

  @Builtin(doc = "Gives the file another name; a file which has that name is replaced.")
  UrbiFile rename(Frame frame, CallSite site, UrbiFile self, UrbiObject name) {
    return moved(frame, site, self, FileAccess.path(frame, site, 1, name));
  }

  private UrbiFile moved(Frame frame, CallSite site, UrbiFile self, UrbiPath to) {
    UrbiPath from = path(frame, site, self);
    if (files.isDirectory(frame, site, to)) {
      throw FileAccess.error(frame, site, Problem.IS_A_DIRECTORY, to);
    }
    files.checkPlace(frame, site, to);
    files.changeSlowly(frame, site, from, () -> files.disk().replace(from.file(), to.file()));
    self.setPath(to);
    return self;
  }

  @Builtin(doc = "Removes the file.")
  void remove(Frame frame, CallSite site, UrbiFile self) {
    UrbiPath path = path(frame, site, self);
    if (files.isDirectory(frame, site, path)) {
      throw FileAccess.error(frame, site, Problem.IS_A_DIRECTORY, path);
    }
    FileAccess.change(frame, site, path, () -> files.disk().delete(path.file()));
  }
}
