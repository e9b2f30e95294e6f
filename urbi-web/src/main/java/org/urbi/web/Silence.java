package org.urbi.web;

import io.netty.channel.ChannelHandlerContext;
import io.netty.handler.codec.http.websocketx.PingWebSocketFrame;
import io.netty.handler.timeout.IdleState;
import io.netty.handler.timeout.IdleStateEvent;
import io.netty.handler.timeout.IdleStateHandler;

/**
 * Closes connections from which nothing whole comes: half a request, however slowly it grows, or a
 * browser that does not answer when it is asked whether it is still there. It stands behind what
 * makes requests and frames of bytes.
 */
final class Silence extends IdleStateHandler {
  private boolean asked;

  Silence(int seconds) {
    super(seconds, 0, 0);
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) throws Exception {
    asked = false;
    super.channelRead(context, message);
  }

  @Override
  protected void channelIdle(ChannelHandlerContext context, IdleStateEvent event) {
    // Whoever is sent a file has nothing to say.
    if (event.state() != IdleState.READER_IDLE || context.pipeline().get(Delivery.class) != null) {
      return;
    }
    if (asked || !PagePort.isStream(context.channel())) {
      context.close();
    } else {
      asked = true;
      context.pipeline().lastContext().writeAndFlush(new PingWebSocketFrame());
    }
  }
}
