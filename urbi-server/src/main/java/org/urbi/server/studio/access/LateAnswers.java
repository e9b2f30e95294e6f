package org.urbi.server.studio.access;

import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.log.FailureLog;

/**
 * What is done on the thread of a stream with answers that come later. A defect of ours in that
 * ends the stream, and its other end is told "internal error": it would wait for ever, as nobody
 * asks what became of it.
 */
public final class LateAnswers {
  private LateAnswers() {}

  /**
   * Does something with an answer of the kernel, unless that has closed the connection before. If
   * the kernel has met a defect the stream ends.
   *
   * @return done when that has been done
   */
  public static <T> CompletableFuture<T> take(
      Channel channel, CompletableFuture<T> answer, Consumer<? super T> action) {
    return whenDone(
        channel,
        answer,
        (result, failure) -> {
          if (result != null) {
            action.accept(result);
          } else if (failure != null && !isClosed(failure)) {
            end(channel, failure);
          }
        });
  }

  /** Whether there is no answer because the connection has been closed. */
  private static boolean isClosed(Throwable failure) {
    return failure instanceof CancellationException
        || failure.getCause() instanceof CancellationException;
  }

  /**
   * Does something when an answer has come, or does not come.
   *
   * @param action is given the answer, or else why there is none
   * @return done when that has been done
   */
  public static <T> CompletableFuture<T> whenDone(
      Channel channel,
      CompletableFuture<T> answer,
      BiConsumer<? super @Nullable T, ? super @Nullable Throwable> action) {
    return answer.whenCompleteAsync(
        (result, failure) -> guarding(channel, () -> action.accept(result, failure)).run(),
        channel.eventLoop());
  }

  /** A task for the thread of a stream, which ends it if it fails. */
  public static Runnable guarding(Channel channel, Runnable task) {
    return () -> {
      try {
        task.run();
      } catch (Throwable failure) {
        end(channel, failure);
      }
    };
  }

  private static void end(Channel channel, Throwable failure) {
    ChannelHandlerContext context = channel.pipeline().context(StreamHandler.class);
    if (context == null) {
      FailureLog.internal(StreamHandler.WHERE, failure);
    } else {
      StreamHandler.end(context, failure);
    }
  }
}
