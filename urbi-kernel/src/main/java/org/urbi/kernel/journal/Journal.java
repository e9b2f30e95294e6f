package org.urbi.kernel.journal;

import java.io.IOException;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;

/**
 * What stands between the kernel thread and the outside: every reading of the clock, every message,
 * every look at the machine passes here, and so does what goes out. By default nothing is written
 * down. All methods are called on the kernel thread.
 */
public interface Journal {
  /** Nothing is written down. */
  Journal NONE = new Journal() {};

  /** Whether the outside is only a recording: nothing is to be done there. */
  default boolean isReplay() {
    return false;
  }

  /** Whether there is nothing more to run. */
  default boolean isOver() {
    return false;
  }

  /** Whether {@link #yieldsToMessages} and {@link #stopReason} are to be called always. */
  default boolean countsChecks() {
    return false;
  }

  /**
   * A tick begins.
   *
   * @param now the time, in nanoseconds
   * @return the time of the tick
   */
  default long tick(long now) {
    return now;
  }

  /** The next message that this tick takes, or null. */
  default @Nullable Message next(Supplier<Message> inbox) {
    return inbox.get();
  }

  /** What a look at the outside shows, which does not wait. */
  @SuppressWarnings("unchecked")
  default <T> @Nullable T query(Outcome.Work<T> work) throws IOException {
    return (T) Outcome.of(work).get();
  }

  /**
   * Whether a job that nobody else keeps from going on gives way to news.
   *
   * @param turns how often it has not, lately
   * @param news whether there are any
   */
  default boolean yieldsToMessages(int turns, boolean news) {
    return news;
  }

  /** Whether a job that never lets others run ends here, as somebody may want. */
  default StopReason stopReason(StopReason wanted) {
    return wanted;
  }

  /**
   * Whether a round of jobs is cut short here, because others wait.
   *
   * @param jobs how many jobs of this tick could have run, with the one that does not
   */
  default boolean cutsRound(int jobs, boolean wanted) {
    return wanted;
  }

  /** Bytes go out, in the name of that receiver of messages. */
  default void sent(int from, byte[] bytes) {}

  /** Somebody has asked for something that only he can do, and he is not there. */
  default void missing(Message message) {}

  /** The kernel is about to wait. */
  default void idle() {}

  /** The kernel has ended. */
  default void end() {}
}
