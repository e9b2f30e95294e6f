package org.urbi.kernel.outside;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import org.urbi.kernel.message.Message;

/** Accepts the connections of one server socket, and hands them to the kernel thread. */
final class IncomingConnections {
  private final Outside outside;
  private final Consumer<Network.OpenConnection> listener;
  private final int number;

  /** Accepted connections, in the order of the messages that announce them. */
  private final Queue<SocketChannel> accepted = new ConcurrentLinkedQueue<>();

  /**
   * @param listener called for each connection, on the kernel thread
   */
  IncomingConnections(Outside outside, Consumer<Network.OpenConnection> listener) {
    this.outside = outside;
    this.listener = listener;
    number = outside.inbox().register(this::take);
  }

  /** Accepts connections until the server socket is closed; on a thread of its own. */
  void accept(ServerSocketChannel place) {
    try {
      while (place.isOpen()) {
        arrived(place.accept());
      }
    } catch (IOException e) {
      // The server socket was closed.
    } finally {
      outside.closed(place);
      outside.inbox().post(new Message.ListeningEnded(number));
    }
  }

  private void arrived(SocketChannel channel) {
    try {
      InetSocketAddress local = Network.internet(channel.getLocalAddress());
      InetSocketAddress remote = Network.internet(channel.getRemoteAddress());
      accepted.add(channel);
      outside.inbox().post(new Message.Accepted(number, local, remote));
    } catch (IOException e) {
      // It was closed before it could be used.
      Outside.closeQuietly(channel);
    }
  }

  private void take(Message message) {
    switch (message) {
      case Message.Accepted made -> {
        SocketChannel channel = accepted.poll();
        try {
          listener.accept(
              new Network.OpenConnection(
                  Network.link(outside, channel), made.local(), made.remote()));
        } catch (IOException e) {
          Outside.closeQuietly(Outside.live(channel));
        }
      }
      case Message.ListeningEnded end -> {
        outside.inbox().forget(number);
        outside.scheduler().pace().end();
      }
      default -> throw new IllegalArgumentException(message.toString());
    }
  }
}
