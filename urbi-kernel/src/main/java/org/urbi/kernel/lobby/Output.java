package org.urbi.kernel.lobby;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.urbi.kernel.job.Scheduler;

/**
 * The output of one lobby: lines with a time stamp and the name of a channel. It is sent at the end
 * of the tick.
 */
public final class Output {
  private static final int LARGE = 1 << 16;

  private final Scheduler scheduler;
  private final Consumer<String> client;
  private final BooleanSupplier full;
  private final BooleanSupplier behind;
  private final int most;
  private final ErrorStyle errors;
  private StringBuilder buffer = new StringBuilder();
  private final Runnable atEndOfTick = this::sendRegistered;
  private boolean registered;
  private boolean open = true;
  private long bytesSent;

  public Output(Scheduler scheduler, Consumer<String> client) {
    this(scheduler, client, () -> false, () -> false, ErrorStyle.PLAIN);
  }

  /**
   * @param full whether so much output is unread that the code of the client must not send more
   * @param behind whether so much is that others must not send more
   * @param errors how much is told about errors
   */
  public Output(
      Scheduler scheduler,
      Consumer<String> client,
      BooleanSupplier full,
      BooleanSupplier behind,
      ErrorStyle errors) {
    this.scheduler = scheduler;
    this.client = client;
    this.full = full;
    this.behind = behind;
    this.most = LARGE;
    this.errors = errors;
  }

  private Output(Output other) {
    this.scheduler = other.scheduler;
    this.client = other::write;
    this.full = other.full;
    this.behind = other.behind;
    this.most = 0;
    this.errors = other.errors;
  }

  /** A separate output that sends its bytes through this one, in order. */
  public Output branch() {
    return new Output(this);
  }

  /** How much is told about errors. */
  public ErrorStyle errors() {
    return errors;
  }

  /** Whether it is a {@linkplain #branch branch}. */
  public boolean isBranch() {
    return most == 0;
  }

  /**
   * Sends text on a channel; only its first line has the time stamp.
   *
   * @param channel empty for the one without a name
   */
  public void send(String channel, String text) {
    long milliseconds = scheduler.now() / 1_000_000;
    var line = new StringBuilder(text.length() + 24);
    line.append('[');
    String time = Long.toString(milliseconds);
    for (int i = time.length(); i < 8; i++) {
      line.append('0');
    }
    line.append(time);
    if (!channel.isEmpty()) {
      line.append(':').append(channel);
    }
    line.append("] ").append(text).append('\n');
    write(line.toString());
  }

  /** Sends bytes as they are. */
  public void write(String bytes) {
    if (!open) {
      return;
    }
    buffer.append(bytes);
    bytesSent += bytes.length();
    if (buffer.length() > most) {
      flush();
    } else if (!registered) {
      scheduler.atEndOfTick(atEndOfTick);
      registered = true;
    }
  }

  private void sendRegistered() {
    flush();
    registered = false;
  }

  /** Sends what is waiting. If memory is wanting for that, it goes on waiting. */
  public void flush() {
    if (buffer.length() > 0) {
      String bytes = buffer.toString();
      StringBuilder next = new StringBuilder();
      client.accept(bytes);
      buffer = next;
    }
  }

  /** Whether so much output is unread that the code of the client must not send more. */
  public boolean isFull() {
    return full.getAsBoolean();
  }

  /** Whether so much output is unread that others must not send more. */
  public boolean isBehind() {
    return behind.getAsBoolean();
  }

  /** Ends the output: the client has gone. */
  public void close() {
    flush();
    open = false;
  }

  public boolean isOpen() {
    return open;
  }

  /** How many bytes have been written. */
  public long bytesSent() {
    return bytesSent;
  }
}
