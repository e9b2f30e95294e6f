package org.urbi.sim.page;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.SimpleChannelInboundHandler;
import io.netty.handler.codec.http.websocketx.PingWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler.HandshakeComplete;
import io.netty.handler.timeout.IdleStateEvent;

/**
 * One WebSocket connection. After the handshake it becomes a viewer. A silent connection gets a
 * ping, and is closed if it does not answer.
 */
final class ViewerHandler extends SimpleChannelInboundHandler<WebSocketFrame> {
  private final Viewers viewers;
  private boolean viewing;
  private boolean asked;

  ViewerHandler(Viewers viewers) {
    this.viewers = viewers;
  }

  @Override
  protected void channelRead0(ChannelHandlerContext context, WebSocketFrame frame) {
    // Pongs, and what else a browser may say: it is there.
    asked = false;
  }

  @Override
  public void userEventTriggered(ChannelHandlerContext context, Object event) {
    switch (event) {
      case HandshakeComplete done -> {
        viewing = true;
        viewers.add(context.channel());
      }
      case IdleStateEvent idle -> {
        if (!viewing || asked) {
          context.close();
        } else {
          asked = true;
          context.writeAndFlush(new PingWebSocketFrame());
        }
      }
      default -> context.fireUserEventTriggered(event);
    }
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
    // A broken connection or a malformed message: the others are not concerned.
    context.close();
  }
}
