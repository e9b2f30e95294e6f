package org.urbi.sim.page;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.SimpleChannelInboundHandler;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler.HandshakeComplete;

/** One WebSocket connection. After the handshake it becomes a viewer. */
final class ViewerHandler extends SimpleChannelInboundHandler<WebSocketFrame> {
  private final Viewers viewers;

  ViewerHandler(Viewers viewers) {
    this.viewers = viewers;
  }

  @Override
  protected void channelRead0(ChannelHandlerContext context, WebSocketFrame frame) {
    // Pongs, and what else a browser may say: nobody waits for it.
  }

  @Override
  public void userEventTriggered(ChannelHandlerContext context, Object event) {
    if (event instanceof HandshakeComplete) {
      viewers.add(context.channel());
    } else {
      context.fireUserEventTriggered(event);
    }
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
    // A broken connection or a malformed message: the others are not concerned.
    context.close();
  }
}
