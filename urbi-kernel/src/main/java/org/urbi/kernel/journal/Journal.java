package org.urbi.kernel.journal;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;

/**
 * Stands between the kernel thread and the outside: every reading of the clock, every message,
 * every query of the machine, and all output passes through it, so that a run can be recorded and
 * replayed. By default nothing is recorded. All methods are called on the kernel thread.
 */
public interface Journal {
  /** Records nothing. */
  Journal NONE = new Journal() {};

  /** Stands for no lobby at all, where the number of a lobby in a round is expected. */
  int NOBODY = -1;

  /** Whether the outside is only a recording, so that nothing must be done there. */
  default boolean isReplay() {
    return false;
  }

  /** Whether the recording has ended, so that nothing more must run. */
  default boolean isOver() {
    return false;
  }

  /**
   * Whether {@link #yieldsToMessages}, {@link #stopReason} and {@link #refusesSwitch} are to be
   * called always.
   */
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

  /** The next message that a job takes in the middle of a tick, or null. */
  default @Nullable Message nextAtOnce(Supplier<@Nullable Message> inbox) {
    return inbox.get();
  }

  /** Queries the outside without waiting, for instance whether a file exists. */
  default <T> @Nullable T query(Outcome.Work<T> work) throws IOException {
    return Outcome.now(work);
  }

  /** Queries what is always there, and cannot fail. */
  default <T> T ask(Supplier<T> work) {
    try {
      return requireNonNull(query(work::get), "what is asked for is there");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Whether the only runnable job must let messages be taken.
   *
   * @param turns how often it has continued without that
   * @param news whether messages are waiting
   */
  default boolean yieldsToMessages(int turns, boolean news) {
    return news;
  }

  /**
   * Nothing is left to run: whether more has come already, so that the kernel is not quiet.
   *
   * @param news whether messages are waiting
   */
  default boolean hasNewsAtRest(boolean news) {
    return news;
  }

  /** Whether and why a job that never lets others run must end here. */
  default StopReason stopReason(StopReason wanted) {
    return wanted;
  }

  /**
   * Whether a round of jobs is cut short here, because others wait, and by whom; or whether a lobby
   * that could run again in this round may not.
   *
   * @param jobs how often this was asked in this round so far, for either of the two reasons
   * @param wanted the number of whom to blame; {@link #NOBODY} if it should go on
   * @return likewise
   */
  default int cutsRound(int jobs, int wanted) {
    return wanted;
  }

  /**
   * A job is about to let others run: whether the recorded run was refused that, because the stack
   * of the job could not be put away.
   */
  default boolean refusesSwitch() {
    return false;
  }

  /** The virtual machine has refused the switch that was asked about last. */
  default void switchRefused() {}

  /** Whether a job that was refused a switch in this turn tries again. */
  default boolean triesSwitchAgain(boolean wanted) {
    return wanted;
  }

  /**
   * Whether an object to which only a loose reference leads is missing; asked whenever somebody
   * looks for one that has not been missed yet.
   *
   * @param gone whether the garbage collector has taken it; a replay has it still
   */
  default boolean misses(boolean gone) {
    return gone;
  }

  /** Records bytes that are sent out by that message receiver. */
  default void sent(int from, byte[] bytes) {}

  /** A message is for a receiver that a replay does not have. */
  default void missing(Message message) {}

  /** The kernel is about to wait. */
  default void idle() {}

  /** The kernel has ended. */
  default void end() {}
}
