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
import org.urbi.web.Farewell;
import org.urbi.web.Refused;
import org.urbi.web.StreamFailure;
import org.urbi.web.TooLongMessage;

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

  /**
   * What tells it why it is refused.
   *
   * @param again after how many seconds it may be worth to come again; 0 if it is of no use
   */
  protected abstract WebSocketFrame refusal(String reason, int again);

  @Override
  public final void userEventTriggered(ChannelHandlerContext context, Object event) {
    if (event instanceof HandshakeComplete done) {
      Channel channel = context.channel();
      try {
        Role role = admission.admit(done.requestUri(), channel);
        admitted = true;
        pause =
            channel
                .eventLoop()
                .scheduleAtFixedRate(
                    () -> requests = Math.max(0, requests - mostRequests), 1, 1, TimeUnit.SECONDS);
        admitted(channel, role, done.requestUri());
      } catch (Refused e) {
        WebSocketCloseStatus status =
            e.again() == 0
                ? WebSocketCloseStatus.POLICY_VIOLATION
                : WebSocketCloseStatus.TRY_AGAIN_LATER;
        refuse(channel, status, String.valueOf(e.getMessage()), e.again());
      }
    }
  }

  private void refuse(Channel channel, WebSocketCloseStatus status, String reason, int again) {
    if (!refused) {
      refused = true;
      channel.write(refusal(reason, again));
      Farewell.say(channel, new CloseWebSocketFrame(status, reason));
    }
  }

  @Override
  protected final void channelRead0(ChannelHandlerContext context, WebSocketFrame frame) {
    if (refused || !admitted || frame instanceof PongWebSocketFrame) {
      return;
    }
    if (++requests > mostRequests * 2) {
      String reason = "too many requests: at most " + mostRequests + " in a second";
      refuse(context.channel(), WebSocketCloseStatus.POLICY_VIOLATION, reason, 0);
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
    if (cause instanceof TooLongMessage) {
      String reason = String.valueOf(cause.getMessage());
      refuse(context.channel(), WebSocketCloseStatus.MESSAGE_TOO_BIG, reason, 0);
    } else {
      end(context, cause);
    }
  }

  static void end(ChannelHandlerContext context, Throwable cause) {
    StreamFailure.close(context, cause, WHERE);
  }
}
