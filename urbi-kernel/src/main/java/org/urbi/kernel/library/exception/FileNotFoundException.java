package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** A file that is not there (manual, "Exception"). */
@UrbiType(
    value = "Exception.FileNotFound",
    protos = {"Exception"},
    doc = "A file that is not there.")
final class FileNotFoundException {
  private FileNotFoundException() {}

  @Builtin(doc = "Of that name.")
  static void init(UrbiObject self, UrbiObject name) {
    ExceptionType.set(self, "name", name);
  }

  @Builtin(doc = "The name of the file.")
  static String asString(Frame frame, UrbiObject self) {
    return "file not found: " + ExceptionType.text(frame, self, "name");
  }
}
