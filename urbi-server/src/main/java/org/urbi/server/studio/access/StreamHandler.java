package org.urbi.server.studio.access;

import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.SimpleChannelInboundHandler;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.PongWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketCloseStatus;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler.HandshakeComplete;
import io.netty.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.trust.Role;
import org.urbi.web.StreamFailure;

/** The stream of somebody who must be let in, and may not ask for too much at a time. */
public abstract class StreamHandler extends SimpleChannelInboundHandler<WebSocketFrame> {
  static final String WHERE = "the studio";

  private final Admission admission;
  private final int mostRequests;
  private boolean admitted;
  private boolean refused;
  private int requests;
  private @Nullable ScheduledFuture<?> pause;

  /**
   * @param mostRequests how many frames may come at once, and in each second
   */
  protected StreamHandler(Admission admission, int mostRequests) {
    this.admission = admission;
    this.mostRequests = mostRequests;
  }

  /**
   * It has been let in.
   *
   * @param uri what it has asked for, with what is behind {@code ?}
   */
  protected abstract void admitted(Channel channel, Role role, String uri);

  /** Takes a frame of one that has been let in. */
  protected abstract void received(Channel channel, WebSocketFrame frame);

  /** One that has been let in has gone. */
  protected abstract void left();

  /** What tells it why it is refused. */
  protected abstract WebSocketFrame refusal(String reason);

  @Override
  public final void userEventTriggered(ChannelHandlerContext context, Object event) {
    if (event instanceof HandshakeComplete done) {
      Channel channel = context.channel();
      try {
        Role role = admission.admit(done.requestUri(), channel.remoteAddress());
        admitted = true;
        pause =
            channel
                .eventLoop()
                .scheduleAtFixedRate(
                    () -> requests = Math.max(0, requests - mostRequests), 1, 1, TimeUnit.SECONDS);
        admitted(channel, role, done.requestUri());
      } catch (Refused e) {
        refuse(channel, String.valueOf(e.getMessage()));
      }
    }
  }

  /**
   * Says goodbye, and passes over what comes until that is answered: to close at once would take
   * back what has just been sent if more has come in.
   */
  private void refuse(Channel channel, String reason) {
    refused = true;
    channel.write(refusal(reason));
    channel.writeAndFlush(new CloseWebSocketFrame(WebSocketCloseStatus.POLICY_VIOLATION));
  }

  @Override
  protected final void channelRead0(ChannelHandlerContext context, WebSocketFrame frame) {
    if (refused || !admitted || frame instanceof PongWebSocketFrame) {
      return;
    }
    if (++requests > mostRequests * 2) {
      refuse(context.channel(), "too many requests: at most " + mostRequests + " in a second");
    } else {
      received(context.channel(), frame);
    }
  }

  @Override
  public final void channelInactive(ChannelHandlerContext context) {
    if (pause != null) {
      pause.cancel(false);
    }
    if (admitted) {
      left();
    }
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
    end(context, cause);
  }

  static void end(ChannelHandlerContext context, Throwable cause) {
    StreamFailure.close(context, cause, WHERE);
  }
}
