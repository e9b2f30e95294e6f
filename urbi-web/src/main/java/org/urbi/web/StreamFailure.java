package org.urbi.web;

import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.handler.codec.DecoderException;
import io.netty.handler.codec.PrematureChannelClosureException;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketCloseStatus;
import io.netty.handler.codec.http.websocketx.WebSocketHandshakeException;
import io.netty.handler.timeout.TimeoutException;
import java.io.IOException;
import java.lang.System.Logger.Level;

/** The end of a stream of messages at which something was thrown. */
public final class StreamFailure {
  private static final String LOGGER = "urbi.web";

  private StreamFailure() {}

  /**
   * Closes the connection; the others are not concerned. Connections break, also within a message,
   * peers send what is malformed, or do not take what they asked for: that is nothing to tell.
   * Whoever has sent too much at once is told how much it may be. Anything else is a defect of
   * ours: it goes to the log of the process with its stack, and the other end is told "internal
   * error".
   *
   * @param doing what failed, for the log
   */
  public static void close(ChannelHandlerContext context, Throwable cause, String doing) {
    if (cause instanceof TooLongMessage) {
      Farewell.say(
          context.channel(),
          new CloseWebSocketFrame(
              WebSocketCloseStatus.MESSAGE_TOO_BIG, String.valueOf(cause.getMessage())));
      return;
    }
    if (isOfTheOtherEnd(cause)) {
      context.close();
      return;
    }
    try {
      log(doing, cause);
    } finally {
      context
          .writeAndFlush(
              new CloseWebSocketFrame(WebSocketCloseStatus.INTERNAL_SERVER_ERROR, "internal error"))
          .addListener(ChannelFutureListener.CLOSE);
    }
  }

  /** Writes a defect of ours to the log of the process, with its stack. */
  static void log(String where, Throwable defect) {
    System.getLogger(LOGGER).log(Level.ERROR, "internal error in " + where, defect);
  }

  private static boolean isOfTheOtherEnd(Throwable cause) {
    return cause instanceof IOException
        || cause instanceof DecoderException
        || cause instanceof TimeoutException
        || cause instanceof PrematureChannelClosureException
        || cause instanceof WebSocketHandshakeException;
  }
}
