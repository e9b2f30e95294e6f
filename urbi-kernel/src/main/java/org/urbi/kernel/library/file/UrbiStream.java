package org.urbi.kernel.library.file;

import java.io.Closeable;
import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.Outside;

/** The common part of InputStream and OutputStream (manual, "Stream"). */
abstract class UrbiStream<T extends Closeable> extends UrbiObject {
  private @Nullable T channel;

  UrbiStream(Shape shape, @Nullable T channel) {
    super(shape);
    this.channel = channel;
  }

  void open(T opened) {
    channel = opened;
  }

  boolean isOpen() {
    return channel != null;
  }

  /** The open source or sink; throws if the stream is closed. */
  T channel(Frame frame, CallSite site) {
    if (channel == null) {
      throw frame.error(site, Problem.STREAM_CLOSED);
    }
    return channel;
  }

  void close(Frame frame, CallSite site, Outside outside) {
    T open = channel(frame, site);
    channel = null;
    outside.closed(open);
    try {
      open.close();
    } catch (IOException e) {
      throw failed(frame, site, e);
    }
  }

  /** Something is wrong with the file or the pipe. */
  static UrbiException failed(Frame frame, CallSite site, IOException failure) {
    return frame.error(site, Problem.REASON, FileAccess.lowered(FileAccess.reason(failure)));
  }
}
