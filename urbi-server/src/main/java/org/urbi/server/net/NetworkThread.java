package org.urbi.server.net;

import io.netty.util.concurrent.EventExecutor;
import java.util.concurrent.RejectedExecutionException;

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
}
