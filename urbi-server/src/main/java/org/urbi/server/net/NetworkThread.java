package org.urbi.server.net;

import io.netty.channel.Channel;
import io.netty.util.concurrent.EventExecutor;
import io.netty.util.concurrent.ScheduledFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;

/** Executes work on the thread of a channel. */
final class NetworkThread {
  private NetworkThread() {}

  /** Executes work there, unless the server has been closed. */
  static void execute(EventExecutor thread, Runnable work) {
    try {
      thread.execute(work);
    } catch (RejectedExecutionException e) {
      // All channels are closed, and the kernel knows or will know.
    }
  }

  /** Closes a channel after that time at the latest. */
  static void close(Channel channel, int seconds) {
    ScheduledFuture<?> last =
        channel.eventLoop().schedule((Runnable) channel::close, seconds, TimeUnit.SECONDS);
    channel.closeFuture().addListener(closed -> last.cancel(false));
  }
}
