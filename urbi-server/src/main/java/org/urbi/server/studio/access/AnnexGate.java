package org.urbi.server.studio.access;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler.HandshakeComplete;
import io.netty.util.ReferenceCountUtil;
import org.urbi.kernel.trust.Role;
import org.urbi.web.Annex;
import org.urbi.web.StreamFailure;

/** Lets a browser in to the stream of a component's page by its token, and then gives way to it. */
public final class AnnexGate extends ChannelInboundHandlerAdapter {
  /** The status of the close, by which the page knows that to come again is of no use. */
  private static final int REFUSED = 4003;

  private final Admission admission;
  private final Annex annex;

  public AnnexGate(Admission admission, Annex annex) {
    this.admission = admission;
    this.annex = annex;
  }

  @Override
  public void userEventTriggered(ChannelHandlerContext context, Object event) {
    if (event instanceof HandshakeComplete done) {
      try {
        Role role = admission.admit(done.requestUri(), context.channel().remoteAddress());
        String refusal =
            role == Role.OBSERVER ? "You are an observer, who sees and cannot change." : "";
        context.pipeline().addLast(annex.viewer().apply(refusal));
        context.fireUserEventTriggered(event);
        context.pipeline().remove(this);
      } catch (Refused e) {
        context.writeAndFlush(new CloseWebSocketFrame(REFUSED, String.valueOf(e.getMessage())));
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
    StreamFailure.close(context, cause, "a page in the studio");
  }
}
