package org.urbi.server.net;

import io.netty.buffer.Unpooled;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.group.ChannelGroup;
import java.nio.charset.StandardCharsets;
import org.urbi.server.Trace;

/** Whether there may be one client more. */
final class ConnectionLimit {
  private final ChannelGroup clients;
  private final int most;
  private final Trace trace;
  private final DescriptorReserve headroom = new DescriptorReserve();
  private boolean told;

  /**
   * @param clients those that are connected
   * @param most how many there may be at a time; 0 for as many as there are descriptors
   */
  ConnectionLimit(ChannelGroup clients, int most, Trace trace) {
    this.clients = clients;
    this.most = most;
    this.trace = trace;
  }

  /** Counts a new client in; or tells it why it is not let in, and closes its connection. */
  boolean admits(Channel client) {
    if (most > 0 && clients.size() >= most) {
      refuse(client, "this server takes " + most + " clients at most");
    } else if (!headroom.admitsOne()) {
      refuse(client, "this server has no file descriptor left for another client");
    } else {
      told = false;
      clients.add(client);
      return true;
    }
    return false;
  }

  private void refuse(Channel client, String reason) {
    if (!told) {
      // Once, and not for each of a flood.
      told = true;
      trace.log("clients are refused from now on: " + reason);
    }
    client.config().setAutoRead(false);
    client
        .writeAndFlush(
            Unpooled.copiedBuffer(
                "[00000000:error] !!! " + reason + ": closing\n", StandardCharsets.ISO_8859_1))
        .addListener(ChannelFutureListener.CLOSE);
  }
}
