package org.urbi.server.net;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import java.util.concurrent.TimeUnit;
import org.urbi.server.Trace;

/**
 * Pauses a listening channel for which the system has no socket for another client. Clients wait in
 * the system's queue until it tries again.
 */
final class AcceptFailures extends ChannelInboundHandlerAdapter {
  private static final long PAUSE_MILLISECONDS = 100;

  private final Trace trace;
  private boolean told;

  AcceptFailures(Trace trace) {
    this.trace = trace;
  }

  @Override
  public void channelRead(ChannelHandlerContext listener, Object client) {
    told = false;
    listener.fireChannelRead(client);
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext listener, Throwable cause) {
    if (!told) {
      told = true;
      trace.log("cannot let a client in, trying again until it can be: " + cause.getMessage());
    }
    var config = listener.channel().config();
    config.setAutoRead(false);
    listener
        .executor()
        .schedule(() -> config.setAutoRead(true), PAUSE_MILLISECONDS, TimeUnit.MILLISECONDS);
  }
}
