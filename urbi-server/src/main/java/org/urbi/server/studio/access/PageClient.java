package org.urbi.server.studio.access;

import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import java.net.InetSocketAddress;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import org.urbi.kernel.Client;
import org.urbi.kernel.trust.Role;

/** What the kernel knows of somebody who looks by a stream. On the kernel thread. */
public final class PageClient implements Client {
  /** How much output of the lobby may wait; more is left out, and that is told. */
  private static final int MOST_OUTPUT = 1 << 18;

  private final Channel channel;
  private final Role role;
  private final Function<String, ChannelFuture> output;
  private final AtomicInteger waiting = new AtomicInteger();
  private final AtomicLong leftOut = new AtomicLong();

  /**
   * @param output sends output of the lobby, on the thread of the channel
   */
  public PageClient(Channel channel, Role role, Function<String, ChannelFuture> output) {
    this.channel = channel;
    this.role = role;
    this.output = output;
  }

  @Override
  public void output(String bytes) {
    int length = bytes.length();
    if (waiting.addAndGet(length) <= MOST_OUTPUT) {
      execute(() -> send(bytes));
    } else {
      leftOut.addAndGet(length);
      if (waiting.addAndGet(-length) == 0) {
        execute(this::tellLoss);
      }
    }
  }

  private void send(String bytes) {
    output
        .apply(bytes)
        .addListener(written -> {
          waiting.addAndGet(-bytes.length());
          tellLoss();
        });
  }

  private void tellLoss() {
    long lost = leftOut.getAndSet(0);
    if (lost > 0) {
      String told = "*** " + lost + " bytes of output are left out: too much at once\n";
      waiting.addAndGet(told.length());
      send(told);
    }
  }

  @Override
  public void closed() {
    execute(channel::close);
  }

  /** Does something on the thread of the channel, unless the port has been closed. */
  public void execute(Runnable work) {
    try {
      channel.eventLoop().execute(LateAnswers.guarding(channel, work));
    } catch (RejectedExecutionException e) {
      // Nobody is served any more.
    }
  }

  @Override
  public long unread() {
    return waiting.get();
  }

  @Override
  public Role role() {
    return role;
  }

  @Override
  public String remoteAddress() {
    return ((InetSocketAddress) channel.remoteAddress()).getAddress().getHostAddress();
  }
}
