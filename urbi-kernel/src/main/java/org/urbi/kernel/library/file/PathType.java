package org.urbi.kernel.library.file;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.value.Hashing;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.World;
import org.urbi.lang.print.StringEscape;

/** Names of files and directories (manual, "Path"). */
@UrbiType(
    value = "Path",
    protos = {"Comparable", "Orderable"},
    doc = "The name of a file or directory.",
    needs = Permission.NOTHING)
final class PathType {
  private final FileAccess files;
  private final WorkingDirectory workingDirectory;

  PathType(FileAccess files, WorkingDirectory workingDirectory) {
    this.files = files;
    this.workingDirectory = workingDirectory;
  }

  UrbiObject newPrototype(World world) {
    return new UrbiPath(world.values().object.cloneShape(), "/", workingDirectory);
  }

  @Builtin(doc = "Makes it the path of that text.", needs = Permission.CHANGE)
  static UrbiObject init(Frame caller, CallSite site, UrbiPath self, String path) {
    FileAccess.checkNotPrototype(caller, site, self, "Path");
    FileAccess.checkName(caller, site, path);
    self.setText(path);
    return self;
  }

  // ------------------------------------------------------------------ the name

  @Builtin(doc = "Whether it starts from the root.")
  static boolean absolute(UrbiPath self) {
    return self.isAbsolute();
  }

  @Builtin(doc = "The names in it, the outermost directory first.")
  static List<UrbiString> asList(Frame caller, UrbiPath self) {
    return self.names().stream().map(caller.interpreter().values()::string).toList();
  }

  @Builtin(doc = "The path, to be shown.")
  static String asPrintable(UrbiPath self) {
    return "Path(" + StringEscape.quote(self.text()) + ")";
  }

  @Builtin(doc = "The text of the path.")
  static String asString(UrbiPath self) {
    return self.text();
  }

  @Builtin(doc = "The last name.")
  static String basename(UrbiPath self) {
    return self.text().substring(self.text().lastIndexOf('/') + 1);
  }

  @Builtin(doc = "The path of the directory it is in.")
  static UrbiPath dirname(UrbiPath self) {
    int slash = self.text().lastIndexOf('/');
    return self.sibling(slash < 0 ? "." : slash == 0 ? "/" : self.text().substring(0, slash));
  }

  @Builtin(value = "/", doc = "The path of rhs, a relative Path or String, in this directory.")
  static UrbiPath divide(Frame caller, CallSite site, UrbiPath self, UrbiObject rhs) {
    String right =
        rhs instanceof UrbiPath path ? path.text() : Arguments.text(caller, site, 1, rhs);
    if (right.startsWith("/")) {
      throw caller.error(site, Problem.ABSOLUTE_PATH, right);
    }
    String text = self.text() + "/" + right;
    FileAccess.checkLength(caller, site, text);
    return self.sibling(text);
  }

  @Builtin(value = "==", doc = "Whether that is a path with the same text.")
  static boolean equals(UrbiPath self, UrbiObject that) {
    return that instanceof UrbiPath other && self.text().equals(other.text());
  }

  @Builtin(value = "<", doc = "Whether its text comes before that of that.")
  static boolean less(UrbiPath self, UrbiPath that) {
    return self.text().compareTo(that.text()) < 0;
  }

  @Builtin(doc = "A Hash, equal for equal paths.")
  static UrbiHash hash(Frame caller, UrbiPath self) {
    return Hashing.hash(caller, UrbiHash.mix(7, Hashing.code(caller, self.text())));
  }

  // ------------------------------------------------------------------ the file

  @Builtin(doc = "Makes it the working directory, and returns that.", needs = Permission.OWNER)
  UrbiPath cd(Frame caller, CallSite site, UrbiPath self) {
    if (!files.isDirectory(caller, site, self)) {
      throw caller.error(site, Problem.NO_SUCH_DIRECTORY, self.text());
    }
    self.working().move(self.file());
    return cwd(self);
  }

  @Builtin(doc = "The working directory.")
  static UrbiPath cwd(UrbiPath self) {
    return self.sibling(UrbiPath.encoded(self.working().path()));
  }

  @Builtin(doc = "Whether there is something of that name.", needs = Permission.USER)
  boolean exists(Frame caller, CallSite site, UrbiPath self) {
    return files.exists(caller, site, self);
  }

  @Builtin(doc = "Whether it is a directory.", needs = Permission.USER)
  boolean isDir(Frame caller, CallSite site, UrbiPath self) {
    return files.isDirectory(caller, site, self);
  }

  @Builtin(doc = "Whether it is a regular file.", needs = Permission.USER)
  boolean isReg(Frame caller, CallSite site, UrbiPath self) {
    return files.isRegularFile(caller, site, self);
  }

  @Builtin(doc = "The File or the Directory of that name.", needs = Permission.USER)
  UrbiObject open(Frame caller, CallSite site, UrbiPath self) {
    checkExists(caller, site, self);
    String type = files.isDirectory(caller, site, self) ? "Directory" : "File";
    return caller
        .interpreter()
        .send(caller, caller.interpreter().world().prototype(type), "new", self);
  }

  @Builtin(doc = "Whether it can be read.", needs = Permission.USER)
  boolean readable(Frame caller, CallSite site, UrbiPath self) {
    checkExists(caller, site, self);
    return FileAccess.quickly(caller, site, self, () -> files.disk().isReadable(self.file()));
  }

  @Builtin(doc = "Whether it can be written.", needs = Permission.USER)
  boolean writable(Frame caller, CallSite site, UrbiPath self) {
    checkExists(caller, site, self);
    return FileAccess.quickly(caller, site, self, () -> files.disk().isWritable(self.file()));
  }

  private void checkExists(Frame caller, CallSite site, UrbiPath self) {
    if (!files.exists(caller, site, self)) {
      throw caller.error(site, Problem.DOES_NOT_EXIST, self.text());
    }
  }
}
