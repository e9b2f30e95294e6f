package org.urbi.kernel.journal;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;

/** One line of a recording. The number by which {@link EntryCodec} writes each never changes. */
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

  /** A message is taken. */
  record MessageTaken(Message message) implements Entry {}

  /** A look at the outside. */
  record QueryAnswered(Outcome outcome) implements Entry {}

  /** A job gives way to news, after having gone on so often. */
  record YieldedToMessages(int turns) implements Entry {}

  /** A job that never lets others run is ended, at that safepoint of the tick. */
  record JobInterrupted(long safepoint) implements Entry {}

  /** A job that has held the kernel for too long is ended, at that safepoint of the tick. */
  record JobOverdue(long safepoint) implements Entry {}

  /** A round of jobs is cut short before that one of the tick. */
  record RoundCut(int jobs) implements Entry {}

  /**
   * Bytes went out.
   *
   * @param from the number of the receiver of messages in whose name
   * @param head the bytes, or the first of many
   * @param checksum CRC-32C of all
   */
  record BytesSent(int from, int length, byte[] head, int checksum) implements Entry {}

  /** The kernel has ended as it should; always the last. */
  record RunEnded() implements Entry {}
}
