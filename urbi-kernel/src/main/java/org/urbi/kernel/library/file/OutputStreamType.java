package org.urbi.kernel.library.file;

import java.io.IOException;
import java.nio.file.Path;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.World;
import org.urbi.kernel.outside.ByteSink;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.outside.PipeSink;

/** Writing files piece by piece (manual, "OutputStream"). */
@UrbiType(
    value = "OutputStream",
    protos = {"Stream"},
    doc = "Bytes that are written to a file, or to a process.",
    needs = Permission.USER)
public final class OutputStreamType {
  private static final int LARGEST_BYTE = 255;

  private final FileAccess files;
  private final Outside outside;

  OutputStreamType(FileAccess files, Outside outside) {
    this.files = files;
    this.outside = outside;
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiOutputStream(world.values().object.cloneShape(), null);
  }

  /** A stream that writes there. */
  public static UrbiOutputStream stream(Frame frame, ByteSink sink) {
    UrbiObject prototype = frame.interpreter().world().prototype("OutputStream");
    return new UrbiOutputStream(prototype.cloneShape(), sink);
  }

  @Builtin(doc = "Makes it write at the end of that file.")
  UrbiOutputStream init(Frame frame, CallSite site, UrbiOutputStream self, UrbiFile file) {
    FileAccess.checkNotPrototype(frame, site, self, "OutputStream");
    UrbiPath name = FileType.path(frame, site, file);
    Path path = name.file();
    ByteSink sink =
        files.isRegularFile(frame, site, name) || !files.exists(frame, site, name)
            ? FileAccess.quickly(frame, site, name, () -> outside.disk().sink(path))
            : new PipeSink(
                outside,
                files.openSlowly(frame, site, name, () -> outside.disk().output(path)),
                false);
    outside.opened(sink);
    self.open(sink);
    return self;
  }

  private static UrbiOutputStream write(
      Frame frame, CallSite site, UrbiOutputStream self, byte[] bytes) {
    try {
      self.channel(frame, site).write(frame.job(), bytes);
    } catch (IOException e) {
      throw UrbiStream.failed(frame, site, e);
    }
    return self;
  }

  @Builtin(value = "<<", doc = "Writes a value as text.")
  static UrbiOutputStream add(Frame frame, CallSite site, UrbiOutputStream self, UrbiObject that) {
    self.channel(frame, site);
    String text = frame.interpreter().asString(frame, that);
    return write(frame, site, self, Utf8Text.bytes(text));
  }

  @Builtin(doc = "Writes the byte of that number.")
  static UrbiOutputStream put(Frame frame, CallSite site, UrbiOutputStream self, UrbiObject given) {
    self.channel(frame, site);
    double number = Arguments.number(frame, site, 1, given);
    if (number < 0) {
      throw bad(frame, site, given, Problem.NOT_BYTE_NEGATIVE);
    }
    if (number > LARGEST_BYTE) {
      throw bad(frame, site, given, Problem.NOT_BYTE_TOO_LARGE);
    }
    if (number != Math.rint(number)) {
      throw bad(frame, site, given, Problem.NOT_BYTE_FRACTION);
    }
    return write(frame, site, self, new byte[] {(byte) (int) number});
  }

  private static UrbiException bad(Frame frame, CallSite site, UrbiObject given, Problem problem) {
    return frame.interpreter().errors().argumentNumber(site.calledName(), 1, problem, given);
  }

  @Builtin(doc = "Writes what is in buffers.")
  static void flush(Frame frame, CallSite site, UrbiOutputStream self) {
    try {
      self.channel(frame, site).flush(frame.job());
    } catch (IOException e) {
      throw UrbiStream.failed(frame, site, e);
    }
  }
}
