package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import java.nio.charset.StandardCharsets;
import org.urbi.kernel.error.Problem;

/** Errors for clients that have no lobby, written as lobbies write them. */
final class ErrorLine {
  private ErrorLine() {}

  /** A line on that channel. */
  static ByteBuf of(String channel, String text) {
    return Unpooled.copiedBuffer(
        "[00000000:" + channel + "] !!! " + text + "\n", StandardCharsets.ISO_8859_1);
  }

  /** Tells a client for what reason its connection is closed. */
  static ByteBuf closing(String reason) {
    return of("error", Problem.CLOSING.text(reason));
  }
}
