package org.urbi.kernel.library.file;

import java.io.IOException;
import java.lang.ref.Reference;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.outside.ByteSource;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.outside.PipeSource;

/** Reading files piece by piece (manual, "InputStream"). */
@UrbiType(
    value = "InputStream",
    protos = {"Stream"},
    doc = "Bytes that are read from a file, or from a process.",
    needs = Permission.USER)
public final class InputStreamType {
  private final FileAccess files;
  private final Outside outside;

  InputStreamType(FileAccess files, Outside outside) {
    this.files = files;
    this.outside = outside;
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiInputStream(world.values().object.cloneShape(), null);
  }

  /** A stream that reads from there. */
  public static UrbiInputStream stream(Frame frame, ByteSource source) {
    UrbiObject prototype = frame.interpreter().world().prototype("InputStream");
    return new UrbiInputStream(prototype.cloneShape(), source);
  }

  @Builtin(doc = "Makes it read from the beginning of that file.")
  UrbiInputStream init(Frame frame, CallSite site, UrbiInputStream self, UrbiFile file) {
    FileAccess.checkNotPrototype(frame, site, self, "InputStream");
    UrbiPath name = FileType.path(frame, site, file);
    Path path = name.file();
    if (files.isRegularFile(frame, site, name)) {
      ByteSource source = FileAccess.quickly(frame, site, name, () -> outside.disk().source(path));
      outside.opened(source);
      self.open(source);
    } else {
      PipeSource source =
          new PipeSource(
              outside, files.openSlowly(frame, site, name, () -> outside.disk().input(path)));
      outside.opened(source);
      self.openPipe(source);
    }
    return self;
  }

  private static int read(Frame frame, CallSite site, UrbiInputStream self) {
    try {
      return self.channel(frame, site).read(frame.job());
    } catch (IOException e) {
      throw UrbiStream.failed(frame, site, e);
    } finally {
      // While somebody reads it is not forgotten.
      Reference.reachabilityFence(self);
    }
  }

  private static UrbiObject nothing(Frame frame) {
    return frame.interpreter().values().voidObject;
  }

  @Builtin(doc = "The next byte as a number; void at the end.")
  static UrbiObject get(Frame frame, CallSite site, UrbiInputStream self) {
    int next = read(frame, site, self);
    return next < 0 ? nothing(frame) : frame.interpreter().values().number(next);
  }

  @Builtin(doc = "The next byte as a String; void at the end.")
  static UrbiObject getChar(Frame frame, CallSite site, UrbiInputStream self) {
    int next = read(frame, site, self);
    return next < 0
        ? nothing(frame)
        : frame.interpreter().values().string(String.valueOf((char) next));
  }

  @Builtin(doc = "The next line, without its end; void at the end.")
  public static UrbiObject getLine(Frame frame, CallSite site, UrbiInputStream self) {
    int next = read(frame, site, self);
    if (next < 0) {
      return nothing(frame);
    }
    StringBuilder line = new StringBuilder();
    while (next >= 0 && next != '\n') {
      line.append((char) next);
      next = read(frame, site, self);
    }
    if (!line.isEmpty() && line.charAt(line.length() - 1) == '\r') {
      line.setLength(line.length() - 1);
    }
    return frame.interpreter().values().string(line.toString());
  }

  @Builtin(doc = "The lines up to the end.")
  static List<UrbiObject> asList(Frame frame, CallSite site, UrbiInputStream self) {
    List<UrbiObject> lines = new ArrayList<>();
    UrbiObject line = getLine(frame, site, self);
    while (line != nothing(frame)) {
      lines.add(line);
      line = getLine(frame, site, self);
    }
    return lines;
  }
}
