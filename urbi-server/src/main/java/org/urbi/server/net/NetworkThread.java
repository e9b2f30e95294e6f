package org.urbi.server.net;

import io.netty.channel.Channel;
import io.netty.util.concurrent.EventExecutor;
import io.netty.util.concurrent.ScheduledFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;

/** Gives work to the thread of a channel. */
final class NetworkThread {
  private NetworkThread() {}

  /** Has something done there; or not at all, once the server has been closed. */
  static void execute(EventExecutor thread, Runnable work) {
    try {
      thread.execute(work);
    } catch (RejectedExecutionException e) {
      // All the channels are closed, and the kernel will hear of it or has.
    }
  }

  /** Closes a channel after so long at the latest; and lets go of it when it has been closed. */
  static void close(Channel channel, int seconds) {
    ScheduledFuture<?> last =
        channel.eventLoop().schedule((Runnable) channel::close, seconds, TimeUnit.SECONDS);
    channel.closeFuture().addListener(closed -> last.cancel(false));
  }
}
