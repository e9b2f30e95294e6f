package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.socket.ChannelInputShutdownEvent;
import io.netty.util.AttributeKey;
import io.netty.util.concurrent.ScheduledFuture;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.TokenThrottle;
import org.urbi.server.trust.Tokens;

/**
 * Authenticates a client by its first line, which may be a comment with a token: {@code //token
 * TOKEN}. A client with a token gets the role of the token; a client without one gets the default
 * role, if there is one. Without a default role, no other handler sees the client before it is
 * authenticated.
 */
final class TokenAuthenticator extends ChannelInboundHandlerAdapter {
  private static final String LINE = "//token ";
  private static final int MAX_LINE = 512;
  private static final int SECONDS_TO_SHOW_IT = 10;
  private static final AttributeKey<Role> ROLE =
      AttributeKey.valueOf(TokenAuthenticator.class, "role");

  private final AccessPolicy accessPolicy;
  private final TokenThrottle wrong;
  private final Trace trace;
  private final ByteBuf first = Unpooled.buffer(128);
  private @Nullable ScheduledFuture<?> deadline;
  private boolean admitted;
  private boolean refused;

  TokenAuthenticator(AccessPolicy accessPolicy, TokenThrottle wrong, Trace trace) {
    this.accessPolicy = accessPolicy;
    this.wrong = wrong;
    this.trace = trace;
  }

  /** The role of the client of a channel; owner if clients are not authenticated. */
  static Role role(ChannelHandlerContext context) {
    Role role = context.channel().attr(ROLE).get();
    return role == null ? Role.OWNER : role;
  }

  @Override
  public void channelActive(ChannelHandlerContext context) {
    if (accessPolicy.defaultRole() != null) {
      admit(context, accessPolicy.defaultRole());
    } else {
      deadline =
          context
              .executor()
              .schedule(() -> refuse(context, asked()), SECONDS_TO_SHOW_IT, TimeUnit.SECONDS);
    }
  }

  private void admit(ChannelHandlerContext context, Role role) {
    context.channel().attr(ROLE).set(role);
    if (admitted) {
      context.fireUserEventTriggered(role);
    } else {
      admitted = true;
      context.fireChannelActive();
    }
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    ByteBuf in = (ByteBuf) message;
    if (!refused) {
      first.writeBytes(in);
    }
    in.release();
    if (!refused) {
      checkFirstLine(context, false);
    }
  }

  private void checkFirstLine(ChannelHandlerContext context, boolean over) {
    String text = first.toString(StandardCharsets.ISO_8859_1);
    int common = Math.min(text.length(), LINE.length());
    int end = text.indexOf('\n');
    boolean shows = text.startsWith(LINE.substring(0, common)) && !(over && end < 0);
    if (!shows) {
      without(context);
    } else if (end >= 0) {
      shown(context, text.substring(LINE.length(), end).strip(), end + 1);
    } else if (text.length() > MAX_LINE) {
      refuse(context, Problem.LONG_TOKEN.text());
    }
  }

  private void without(ChannelHandlerContext context) {
    if (admitted) {
      passOn(context, 0);
    } else {
      refuse(context, asked());
    }
  }

  private static String asked() {
    return Problem.ASKS_FOR_TOKEN.text();
  }

  private void shown(ChannelHandlerContext context, String token, int length) {
    TokenThrottle.Verdict verdict = wrong.judge(accessPolicy, address(context), token);
    Tokens.TokenHolder holder = verdict.holder();
    if (holder == null) {
      if (verdict.isGuess()) {
        trace.log("wrong token: " + context.channel().remoteAddress());
      }
      refuse(context, verdict.reason());
      return;
    }
    trace.debug("token of " + holder.name() + ": " + context.channel().remoteAddress());
    admit(context, holder.role());
    passOn(context, length);
  }

  private static String address(ChannelHandlerContext context) {
    return context.channel().remoteAddress() instanceof InetSocketAddress address
        ? address.getAddress().getHostAddress()
        : String.valueOf(context.channel().remoteAddress());
  }

  private void passOn(ChannelHandlerContext context, int offset) {
    ByteBuf rest = first.retainedSlice(offset, first.writerIndex() - offset);
    context.pipeline().remove(this);
    if (rest.isReadable()) {
      context.fireChannelRead(rest);
    } else {
      rest.release();
    }
  }

  @Override
  public void userEventTriggered(ChannelHandlerContext context, Object event) {
    if (event == ChannelInputShutdownEvent.INSTANCE && !refused) {
      checkFirstLine(context, true);
    }
    context.fireUserEventTriggered(event);
  }

  private void refuse(ChannelHandlerContext context, String reason) {
    if (refused) {
      return;
    }
    refused = true;
    context.channel().config().setAutoRead(false);
    context.writeAndFlush(ErrorLine.closing(reason)).addListener(ChannelFutureListener.CLOSE);
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext context) {
    if (deadline != null) {
      deadline.cancel(false);
    }
    first.release();
  }
}
