package org.urbi.server.net;

import static java.util.Objects.requireNonNull;

import io.netty.channel.Channel;
import java.io.IOException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Connection;

/**
 * Finds out whether a client is still there from whom nothing can be read: it has ended its stream,
 * or the server does not read at present. A socket that has been closed looks the same to TCP as
 * one that only sends no more, until it is sent something. So it is sent one byte of urgent data
 * (RFC 6093), which programs that do not ask for such data never see, and telnet takes for no
 * operation; the system of a client that is gone answers with a reset. That byte is sent once in
 * the life of a connection: only a second one could be taken for ordinary data, by whoever reads
 * slowly.
 *
 * <p>Everything runs on the network thread.
 */
final class PeerProbe {
  /** A client that sends a statement and leaves has it executed if it takes no longer. */
  private static final int FIRST_MILLISECONDS = 40;

  private static final int ANSWER_MILLISECONDS = 10;
  private static final int LONGEST_MILLISECONDS = 1000;

  private static final int HOLD_MILLISECONDS = 20;

  private static final int NO_OPERATION = 0;

  private final Channel channel;
  private final BooleanSupplier isUnheard;
  private final LongSupplier runningTurn;
  private final @Nullable SocketChannel socket;
  private boolean isRunning;
  private boolean hasAsked;
  private boolean hasGone;
  private long turn = Connection.NO_TURN;
  private int pause;

  /**
   * @param isUnheard whether nothing is read from the client; asked on the network thread
   * @param runningTurn the turn in which its code runs, or {@link Connection#NO_TURN}
   */
  PeerProbe(Channel channel, BooleanSupplier isUnheard, LongSupplier runningTurn) {
    this.channel = channel;
    this.isUnheard = isUnheard;
    this.runningTurn = runningTurn;
    this.socket = socketOf(channel);
  }

  /**
   * Nothing is read from now on: closes the channel when a client that is gone holds the kernel.
   */
  void begin() {
    if (socket != null && !isRunning) {
      isRunning = true;
      pause = FIRST_MILLISECONDS;
      next();
    }
  }

  private static @Nullable SocketChannel socketOf(Channel channel) {
    if (channel instanceof ConsoleChannel tcp) {
      return tcp.socketChannel();
    }
    return channel instanceof UnixChannel unix ? unix.javaChannel() : null;
  }

  private void next() {
    channel.eventLoop().schedule(this::look, pause, TimeUnit.MILLISECONDS);
  }

  private void look() {
    isRunning = channel.isOpen() && isUnheard.getAsBoolean();
    if (!isRunning) {
      return;
    }
    boolean holds = holds();
    hasGone = hasGone || isGone();
    if (hasGone && holds) {
      isRunning = false;
      channel.close();
      return;
    }
    if (!hasGone && ask()) {
      pause = ANSWER_MILLISECONDS;
    } else {
      // Others wait for who holds the kernel, and perhaps for this look.
      pause = hasGone || holds ? HOLD_MILLISECONDS : Math.min(2 * pause, LONGEST_MILLISECONDS);
    }
    next();
  }

  /** Whether its code still runs in the same turn as when it was looked at last. */
  private boolean holds() {
    long before = turn;
    turn = runningTurn.getAsLong();
    return turn != Connection.NO_TURN && turn == before;
  }

  /** A Unix domain socket tells without. */
  private boolean ask() {
    if (hasAsked || !(channel instanceof ConsoleChannel tcp)) {
      return false;
    }
    try {
      tcp.socketChannel().socket().sendUrgentData(NO_OPERATION);
      hasAsked = true;
    } catch (IOException e) {
      // Its buffer is full for now, or the next look finds out more.
    }
    return hasAsked;
  }

  /**
   * Java tells of a reset of a socket that it does not read by no other way: whatever is wanted of
   * such a socket is said to be possible, even what never is.
   */
  private boolean isGone() {
    try (Selector selector = Selector.open()) {
      SelectionKey never = requireNonNull(socket).register(selector, SelectionKey.OP_CONNECT);
      selector.selectNow();
      return never.isConnectable();
    } catch (IOException e) {
      // There is no descriptor left to find out.
      return false;
    }
  }
}
