package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.socket.ChannelInputShutdownEvent;
import io.netty.channel.socket.DuplexChannel;
import io.netty.handler.codec.DecoderException;
import io.netty.handler.ssl.SslCloseCompletionEvent;
import io.netty.handler.ssl.SslContext;
import io.netty.handler.ssl.SslContextBuilder;
import io.netty.handler.ssl.SslHandler;
import io.netty.handler.ssl.SslHandshakeCompletionEvent;
import io.netty.handler.ssl.SslProvider;
import io.netty.util.concurrent.ScheduledFuture;
import java.security.cert.X509Certificate;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.server.Trace;
import org.urbi.server.trust.ServerIdentity;

/**
 * Lets clients in by TLS alone. Nobody behind hears of a client before the handshake has gone well;
 * from then on it looks like one without TLS: its {@code close_notify} is the end of its stream. An
 * end without that may be anybody's doing, and is a loss of the connection.
 */
public final class TlsGate extends ChannelInboundHandlerAdapter {
  /** With TLS 1.2 a client that ends its stream could not be answered any more. */
  private static final String VERSION = "TLSv1.3";

  private static final int HANDSHAKE_RECORD = 22;
  private static final int HANDSHAKE_SECONDS = 10;
  private static final int FAREWELL_MILLISECONDS = 1000;

  private final SslContext context;
  private final Trace trace;
  private @Nullable SslHandler tls;
  private @Nullable ScheduledFuture<?> deadline;
  private boolean refused;
  private boolean ended;

  TlsGate(SslContext context, Trace trace) {
    this.context = context;
    this.trace = trace;
  }

  /**
   * What all the connections of a server share.
   *
   * @throws SSLException if the JDK cannot use that identity
   */
  public static SslContext context(ServerIdentity identity) throws SSLException {
    return SslContextBuilder.forServer(
            identity.key(), identity.chain().toArray(X509Certificate[]::new))
        .sslProvider(SslProvider.JDK)
        .protocols(VERSION)
        .build();
  }

  @Override
  public void channelActive(ChannelHandlerContext client) {
    deadline = client.executor().schedule(() -> late(client), HANDSHAKE_SECONDS, TimeUnit.SECONDS);
  }

  private void late(ChannelHandlerContext client) {
    if (tls == null) {
      refuse(client);
    } else {
      trace.debug("client has not ended its TLS handshake: " + client.channel().remoteAddress());
      client.close();
    }
  }

  @Override
  public void channelRead(ChannelHandlerContext client, Object message) {
    if (tls != null) {
      client.fireChannelRead(message);
      return;
    }
    ByteBuf in = (ByteBuf) message;
    if (refused || in.getUnsignedByte(in.readerIndex()) != HANDSHAKE_RECORD) {
      in.release();
      refuse(client);
      return;
    }
    SslHandler handler = context.newHandler(client.alloc());
    handler.setHandshakeTimeoutMillis(0);
    handler.setCloseNotifyFlushTimeoutMillis(FAREWELL_MILLISECONDS);
    tls = handler;
    client.pipeline().addBefore(client.name(), null, handler);
    client.pipeline().fireChannelRead(in);
  }

  /** In plain text: so does the client speak. */
  private void refuse(ChannelHandlerContext client) {
    if (refused) {
      return;
    }
    refused = true;
    trace.turnedAway("client refused, it does not speak TLS: " + client.channel().remoteAddress());
    client.channel().config().setAutoRead(false);
    client
        .writeAndFlush(ErrorLine.closing(Problem.SPEAKS_TLS.text()))
        .addListener(ChannelFutureListener.CLOSE);
  }

  @Override
  public void userEventTriggered(ChannelHandlerContext client, Object event) {
    switch (event) {
      case SslHandshakeCompletionEvent handshake when handshake.isSuccess() -> {
        cancelDeadline();
        client.fireChannelActive();
      }
      case SslHandshakeCompletionEvent handshake ->
          lost(client, "no TLS with this client", handshake.cause());
      case SslCloseCompletionEvent end -> {
        if (end.isSuccess() && !ended) {
          ended = true;
          client.fireUserEventTriggered(ChannelInputShutdownEvent.INSTANCE);
        }
      }
      case ChannelInputShutdownEvent end -> socketEnded(client);
      default -> client.fireUserEventTriggered(event);
    }
  }

  private void socketEnded(ChannelHandlerContext client) {
    if (!ended) {
      trace.debug("client ended without a word of TLS: " + client.channel().remoteAddress());
      client.close();
    } else if (((DuplexChannel) client.channel()).isOutputShutdown()) {
      client.close();
    }
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext client, Throwable failure) {
    Throwable cause = failure instanceof DecoderException ? failure.getCause() : failure;
    if (cause instanceof SSLException) {
      lost(client, "TLS failed", cause);
    } else {
      client.fireExceptionCaught(failure);
    }
  }

  private void lost(ChannelHandlerContext client, String what, Throwable cause) {
    trace.debug(what + ": " + client.channel().remoteAddress() + ": " + cause.getMessage());
    client.close();
  }

  private void cancelDeadline() {
    if (deadline != null) {
      deadline.cancel(false);
    }
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext client) {
    cancelDeadline();
  }
}
