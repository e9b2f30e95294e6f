package org.urbi.server.net;

import io.netty.channel.Channel;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.group.ChannelGroup;
import org.urbi.kernel.error.Problem;
import org.urbi.server.Trace;

/** Limits the number of clients. */
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

  /**
   * Accepts a new client; or tells it why it is refused, closes its connection, and returns false.
   */
  boolean acceptClient(Channel client) {
    if (most > 0 && clients.size() >= most) {
      refuse(client, Problem.MOST_CLIENTS.text(most));
    } else if (!headroom.allowsOneMore()) {
      refuse(client, Problem.NO_DESCRIPTOR.text());
    } else {
      told = false;
      clients.add(client);
      return true;
    }
    return false;
  }

  private void refuse(Channel client, String reason) {
    if (!told) {
      // Logged once, not for each client of a flood.
      told = true;
      trace.log("clients are refused from now on: " + reason);
    }
    client.config().setAutoRead(false);
    client.writeAndFlush(ErrorLine.closing(reason)).addListener(ChannelFutureListener.CLOSE);
  }
}
