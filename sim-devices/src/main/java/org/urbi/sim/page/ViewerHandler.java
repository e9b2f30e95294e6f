package org.urbi.sim.page;

import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.SimpleChannelInboundHandler;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketCloseStatus;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler.HandshakeComplete;
import io.netty.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.web.Farewell;
import org.urbi.web.StreamFailure;

/** One WebSocket connection. After the handshake it becomes a viewer, who may give orders. */
final class ViewerHandler extends SimpleChannelInboundHandler<WebSocketFrame> {
  /** What it is, for the log. */
  static final String WHERE = "the page of a simulated world";

  /** How many orders may come in each second. */
  private static final int MOST_ORDERS = 60;

  private static final String DRIVE = "drive ";
  private static final String HALT = "drive 0 0";

  private final Viewers viewers;
  private final Orders orders;
  private final String refusal;
  private int recent;
  private boolean driving;
  private @Nullable ScheduledFuture<?> second;

  /**
   * @param refusal why whoever looks may not give orders; empty if he may
   */
  ViewerHandler(Viewers viewers, Orders orders, String refusal) {
    this.viewers = viewers;
    this.orders = orders;
    this.refusal = refusal;
  }

  @Override
  protected void channelRead0(ChannelHandlerContext context, WebSocketFrame frame) {
    // Pongs, and what else a browser may say: nobody waits for it.
    if (!(frame instanceof TextWebSocketFrame text) || recent > MOST_ORDERS) {
      return;
    }
    if (++recent > MOST_ORDERS) {
      refuse(context);
      return;
    }
    if (!refusal.isEmpty()) {
      context.writeAndFlush(Viewers.refusal(refusal));
      return;
    }
    String order = text.text();
    if (order.startsWith(DRIVE)) {
      driving = !order.equals(HALT);
    }
    orders.take(Viewers.name(context.channel()), order);
  }

  @Override
  public void userEventTriggered(ChannelHandlerContext context, Object event) {
    if (event instanceof HandshakeComplete) {
      Channel channel = context.channel();
      context.writeAndFlush(Viewers.told("may", refusal));
      viewers.add(channel);
      second = channel.eventLoop().scheduleAtFixedRate(this::forget, 1, 1, TimeUnit.SECONDS);
    } else {
      context.fireUserEventTriggered(event);
    }
  }

  private void refuse(ChannelHandlerContext context) {
    halt(context);
    String reason = "Too many orders: at most " + MOST_ORDERS + " in a second.";
    context.write(Viewers.refusal(reason));
    Farewell.say(
        context.channel(), new CloseWebSocketFrame(WebSocketCloseStatus.POLICY_VIOLATION, reason));
  }

  /** A robot whose driver goes stops. */
  private void halt(ChannelHandlerContext context) {
    if (driving) {
      driving = false;
      orders.take(Viewers.name(context.channel()), HALT);
    }
  }

  private void forget() {
    if (recent <= MOST_ORDERS) {
      recent = 0;
    }
  }

  @Override
  public void channelInactive(ChannelHandlerContext context) {
    if (second != null) {
      second.cancel(false);
    }
    halt(context);
    context.fireChannelInactive();
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
    StreamFailure.close(context, cause, WHERE);
    halt(context);
  }
}
