package org.urbi.web;

import io.netty.channel.ChannelHandlerContext;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.CorruptedWebSocketFrameException;
import io.netty.handler.codec.http.websocketx.WebSocketCloseStatus;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketFrameAggregator;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolConfig;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler;
import org.jspecify.annotations.Nullable;

/**
 * Makes frames of the bytes of a stream. Whoever sends what is no frame is told so; that a message
 * is too long is thrown at the handler of the stream, which knows how its other end is told.
 */
final class StreamProtocol extends WebSocketServerProtocolHandler {
  private static final int HANDSHAKE_MILLISECONDS = 5000;
  private static final int CLOSE_MILLISECONDS = 2000;

  private final int longestMessage;

  StreamProtocol(String path, @Nullable String subprotocols, int longestMessage) {
    super(
        WebSocketServerProtocolConfig.newBuilder()
            .websocketPath(path)
            .checkStartsWith(true)
            .subprotocols(subprotocols)
            .maxFramePayloadLength(longestMessage)
            .closeOnProtocolViolation(false)
            .handshakeTimeoutMillis(HANDSHAKE_MILLISECONDS)
            .forceCloseTimeoutMillis(CLOSE_MILLISECONDS)
            .dropPongFrames(false)
            .build());
    this.longestMessage = longestMessage;
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext context, Throwable cause) throws Exception {
    if (!(cause instanceof CorruptedWebSocketFrameException corrupt)) {
      super.exceptionCaught(context, cause);
    } else if (corrupt.closeStatus().equals(WebSocketCloseStatus.MESSAGE_TOO_BIG)) {
      context.fireExceptionCaught(new TooLongMessage(longestMessage));
    } else {
      Farewell.say(
          context.channel(),
          new CloseWebSocketFrame(corrupt.closeStatus(), String.valueOf(corrupt.getMessage())));
    }
  }

  /** Makes one message of several frames, in which browsers may send a long one. */
  static final class Messages extends WebSocketFrameAggregator {
    private final int longest;

    Messages(int longest) {
      super(longest);
      this.longest = longest;
    }

    @Override
    protected void handleOversizedMessage(ChannelHandlerContext context, WebSocketFrame oversized) {
      context.fireExceptionCaught(new TooLongMessage(longest));
    }
  }
}
