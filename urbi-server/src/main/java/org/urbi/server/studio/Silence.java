package org.urbi.server.studio;

import io.netty.channel.ChannelHandlerContext;
import io.netty.handler.codec.http.websocketx.PingWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler;
import io.netty.handler.timeout.IdleState;
import io.netty.handler.timeout.IdleStateEvent;
import io.netty.handler.timeout.IdleStateHandler;

/**
 * Closes connections from which nothing comes: half a request, or a browser that does not answer
 * when it is asked whether it is still there.
 */
final class Silence extends IdleStateHandler {
  private static final int SECONDS = 10;

  private boolean asked;

  Silence() {
    super(SECONDS, 0, 0);
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) throws Exception {
    asked = false;
    super.channelRead(context, message);
  }

  @Override
  protected void channelIdle(ChannelHandlerContext context, IdleStateEvent event) {
    boolean isStream =
        context.pipeline().get(WebSocketServerProtocolHandler.class) != null
            && context.pipeline().get(StudioFiles.class) == null;
    if (event.state() != IdleState.READER_IDLE) {
      return;
    }
    if (asked || !isStream) {
      context.close();
    } else {
      asked = true;
      context.pipeline().lastContext().writeAndFlush(new PingWebSocketFrame());
    }
  }
}
