package org.urbi.web;

import io.netty.channel.EventLoopGroup;
import io.netty.channel.IoEventLoop;
import io.netty.channel.IoEventLoopGroup;
import io.netty.channel.IoHandlerFactory;
import io.netty.channel.MultiThreadIoEventLoopGroup;
import io.netty.channel.SingleThreadIoEventLoop;
import io.netty.channel.nio.NioIoHandler;
import io.netty.util.concurrent.DefaultThreadFactory;
import io.netty.util.concurrent.ScheduledFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;

/**
 * One thread for many connections, which goes on after an {@code Error} between two of them. What a
 * task that has its time throws is logged: Netty would keep it, and nobody asks for that. What any
 * other task throws is logged by Netty.
 */
public final class NetworkLoop extends SingleThreadIoEventLoop {
  private final String name;
  private final BiConsumer<String, Throwable> log;

  private NetworkLoop(
      IoEventLoopGroup group,
      Executor executor,
      IoHandlerFactory handlers,
      String name,
      BiConsumer<String, Throwable> log) {
    super(group, executor, handlers);
    this.name = name;
    this.log = log;
  }

  /**
   * Starts nothing before the first connection.
   *
   * @param name of the thread, which keeps no program running
   * @param log is given where something has failed, and what it was; on that thread
   */
  public static EventLoopGroup group(String name, BiConsumer<String, Throwable> log) {
    IoHandlerFactory channels = NioIoHandler.newFactory();
    return new MultiThreadIoEventLoopGroup(
        1,
        new DefaultThreadFactory(name, true),
        executor -> new PersistentIoHandler(channels.newHandler(executor), log)) {
      @Override
      protected IoEventLoop newChild(
          Executor executor, IoHandlerFactory handlers, Object... nothing) {
        return new NetworkLoop(this, executor, handlers, name, log);
      }
    };
  }

  private Runnable guarded(Runnable task) {
    return () -> {
      try {
        task.run();
      } catch (Throwable failure) {
        log.accept("the thread " + name, failure);
      }
    };
  }

  @Override
  public ScheduledFuture<?> schedule(Runnable task, long delay, TimeUnit unit) {
    return super.schedule(guarded(task), delay, unit);
  }

  @Override
  public ScheduledFuture<?> scheduleAtFixedRate(
      Runnable task, long delay, long period, TimeUnit unit) {
    return super.scheduleAtFixedRate(guarded(task), delay, period, unit);
  }

  @Override
  public ScheduledFuture<?> scheduleWithFixedDelay(
      Runnable task, long delay, long pause, TimeUnit unit) {
    return super.scheduleWithFixedDelay(guarded(task), delay, pause, unit);
  }
}
