package org.urbi.kernel.library.file;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.Outside;

/** The common part of InputStream and OutputStream (manual, "Stream"). */
@UrbiType(
    value = "Stream",
    doc = "Bytes that go from or to a file, or a process.",
    needs = Permission.USER)
final class StreamType {
  private final Outside outside;

  StreamType(Outside outside) {
    this.outside = outside;
  }

  @Builtin(doc = "Writes what is in buffers, and closes the stream.")
  void close(Frame frame, CallSite site, UrbiObject self) {
    if (!(self instanceof UrbiStream<?> stream)) {
      throw frame.error(site, Problem.STREAM_CLOSED);
    }
    stream.close(frame, site, outside);
  }
}
