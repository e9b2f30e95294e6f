package org.urbi.web;

import io.netty.channel.Channel;
import io.netty.channel.ChannelHandler;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketCloseStatus;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler.HandshakeComplete;
import io.netty.util.ReferenceCountUtil;

/** Lets a browser in to the stream of a page, and then gives way to what handles its frames. */
public abstract class Gate extends ChannelInboundHandlerAdapter {
  /** The status of the close, by which a page knows that to come again is of no use. */
  private static final int REFUSED = 4003;

  private final String page;

  /**
   * @param page what is looked at, for the log
   */
  protected Gate(String page) {
    this.page = page;
  }

  /**
   * Lets a browser in.
   *
   * @param uri what it has asked for
   * @return what handles its frames
   * @throws Refused if it is not let in
   */
  protected abstract ChannelHandler admit(Channel channel, String uri) throws Refused;

  @Override
  public void userEventTriggered(ChannelHandlerContext context, Object event) {
    if (event instanceof HandshakeComplete done) {
      try {
        context.pipeline().addLast(admit(context.channel(), done.requestUri()));
        context.fireUserEventTriggered(event);
        context.pipeline().remove(this);
      } catch (Refused e) {
        int status = e.again() == 0 ? REFUSED : WebSocketCloseStatus.TRY_AGAIN_LATER.code();
        Farewell.say(
            context.channel(), new CloseWebSocketFrame(status, String.valueOf(e.getMessage())));
      }
    } else {
      context.fireUserEventTriggered(event);
    }
  }

  /** Passes over what comes from one that has not been let in. */
  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    if (message instanceof WebSocketFrame) {
      ReferenceCountUtil.release(message);
    } else {
      context.fireChannelRead(message);
    }
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
    StreamFailure.close(context, cause, page);
  }
}
