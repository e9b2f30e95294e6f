package org.urbi.kernel.journal;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;

/** One entry of a recording. The number by which {@link EntryCodec} writes each never changes. */
public sealed interface Entry {
  /**
   * How the kernel was started; always the first.
   *
   * @param program the version of urbi
   * @param startTime seconds from the Epoch to the start
   * @param stackSize of a job, in KiB; 0 for as much as there is
   * @param library the folder of the library's own sources, or null
   * @param logLevel how much of the log is shown
   * @param confinedTo the directory to which the kernel is confined, or null
   * @param userDirectory the directory whose files users may use, or null
   * @param reboots whether somebody starts another kernel after {@code System.reboot}
   */
  record RunStarted(
      String program,
      boolean virtualTime,
      double startTime,
      long seed,
      int stackSize,
      List<String> searchPath,
      @Nullable String library,
      List<String> modulePath,
      String programName,
      List<String> arguments,
      String logLevel,
      @Nullable String confinedTo,
      @Nullable String userDirectory,
      String workingDirectory,
      boolean reboots)
      implements Entry {}

  /** A tick begins, at that time in nanoseconds. */
  record Tick(long now) implements Entry {}

  /** A message was taken from the inbox. */
  record MessageTaken(Message message) implements Entry {}

  /** A message was taken by a job that had waited for it in the middle of a tick. */
  record MessageTakenAtOnce(Message message) implements Entry {}

  /** The answer to a query of the outside, such as whether a file exists. */
  record QueryAnswered(Outcome outcome) implements Entry {}

  /** The only runnable job let messages be taken, after having continued that many times. */
  record YieldedToMessages(int turns) implements Entry {}

  /** Messages were waiting when nothing was left to run: the kernel was not quiet. */
  record NewsWaited() implements Entry {}

  /** A job that never lets others run is ended, at that safepoint of the tick. */
  record JobInterrupted(long safepoint) implements Entry {}

  /** A job that has held the kernel for too long is ended, at that safepoint of the tick. */
  record JobOverdue(long safepoint) implements Entry {}

  /** A job that has allocated too much at one go is ended, at that safepoint of the tick. */
  record JobGreedy(long safepoint) implements Entry {}

  /**
   * A round of jobs was cut short when that was asked for so many times, by which of those it had
   * served; or the turn of a lobby.
   */
  record RoundCut(int jobs, int by) implements Entry {}

  /**
   * The virtual machine refused to put the stack of a job away, which goes on in its turn, at that
   * switch of the tick.
   */
  record SwitchRefused(long number) implements Entry {}

  /** A job that was refused a switch tried again, when it was asked that often in the tick. */
  record SwitchTriedAgain(long look) implements Entry {}

  /** An object was missing, which the garbage collector had taken, at that look of the tick. */
  record ObjectMissed(long look) implements Entry {}

  /**
   * Bytes went out.
   *
   * @param from the number of the message receiver that has sent them
   * @param head the bytes, or the first of many
   * @param checksum the CRC-32C of all bytes
   */
  record BytesSent(int from, int length, byte[] head, int checksum) implements Entry {}

  /** The kernel has ended as it should; always the last. */
  record RunEnded() implements Entry {}
}
