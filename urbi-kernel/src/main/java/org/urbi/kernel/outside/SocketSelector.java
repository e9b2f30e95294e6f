package org.urbi.kernel.outside;

import java.io.IOException;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.Collection;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.KernelPoller;

/**
 * Waits until one of several sockets is readable. Used by one thread, except for {@link #wake}.
 *
 * @param <T> the type of the sockets' owners
 */
public final class SocketSelector<T> implements KernelPoller.Wait, AutoCloseable {
  /** A socket that can be added to one selector. */
  public static final class Socket {
    private final SocketChannel channel;

    /**
     * @param channel in non-blocking mode
     */
    public Socket(SocketChannel channel) {
      this.channel = channel;
    }
  }

  private final Selector selector;
  private long limit;

  /**
   * @throws IOException if the system has no more selectors
   */
  public SocketSelector() throws IOException {
    selector = Selector.open();
  }

  /**
   * Watches a socket.
   *
   * @throws IOException if it is closed
   */
  public void add(Socket socket, T owner) throws IOException {
    // The network thread may close the channel at any moment, which cancels the key.
    try {
      SelectionKey key = socket.channel.keyFor(selector);
      if (key == null) {
        socket.channel.register(selector, SelectionKey.OP_READ, owner);
      } else {
        key.interestOps(SelectionKey.OP_READ);
      }
    } catch (CancelledKeyException e) {
      throw new IOException(Problem.CLOSED.text(), e);
    }
  }

  /** Removes a socket; it may be added again. */
  public void remove(Socket socket) {
    SelectionKey key = socket.channel.keyFor(selector);
    if (key != null) {
      try {
        key.interestOps(0);
      } catch (CancelledKeyException e) {
        // It was closed, and so was removed.
      }
    }
  }

  /** Limits the next wait, in milliseconds; 0 for no limit. */
  public void limit(long milliseconds) {
    limit = milliseconds;
  }

  @Override
  public void await() {
    select(limit);
  }

  /** Polls the sockets without waiting, which also releases those that have been closed. */
  public void pollNow() {
    select(-1);
  }

  private void select(long milliseconds) {
    try {
      if (milliseconds < 0) {
        selector.selectNow();
      } else {
        selector.select(milliseconds);
      }
    } catch (IOException e) {
      // The system has none to tell of.
      selector.selectedKeys().clear();
    }
  }

  /** Adds the owners of the sockets that were readable at the last wait or poll. */
  // What is attached to each key is its owner.
  @SuppressWarnings("unchecked")
  public void ready(Collection<T> owners) {
    for (SelectionKey key : selector.selectedKeys()) {
      if (key.isValid()) {
        owners.add((T) key.attachment());
      }
    }
    selector.selectedKeys().clear();
  }

  @Override
  public void wake() {
    selector.wakeup();
  }

  @Override
  public void close() throws IOException {
    selector.close();
  }
}
