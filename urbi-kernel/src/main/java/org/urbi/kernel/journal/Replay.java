package org.urbi.kernel.journal;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;

/**
 * Runs a recording again: what came from the outside comes from there, and what goes out is
 * compared. Where the run is another than the recorded one, it ends.
 */
public final class Replay implements Journal {
  /** Ends a job of a run that has left its recording. */
  private static final class Diverged extends RuntimeException {
    private static final long serialVersionUID = 1;

    Diverged() {
      super("the run has left its recording", null, false, false);
    }
  }

  private final RecordingReader recording;
  private final Entry.RunStarted beginning;
  private @Nullable Entry next;
  private long now;
  private long ticks;
  private long safepoints;
  private long looks;
  private long switches;
  private long tries;
  private boolean over;
  private @Nullable String difference;

  /**
   * @throws RecordingException if the file is damaged
   */
  public Replay(RecordingReader recording) {
    this.recording = recording;
    if (!(recording.next() instanceof Entry.RunStarted begun)) {
      throw new RecordingException("has no beginning");
    }
    beginning = begun;
    advance();
  }

  /** How the recorded kernel was started. */
  public Entry.RunStarted beginning() {
    return beginning;
  }

  /** How the run differed from the recorded one, or why it could not go on; null if it did not. */
  public @Nullable String difference() {
    return difference;
  }

  /** The time of the tick, in nanoseconds. */
  public long now() {
    return now;
  }

  private void advance() {
    try {
      next = recording.next();
    } catch (RecordingException e) {
      next = null;
      over = true;
      difference = "the recording " + e.getMessage();
      return;
    }
    if (next == null && recording.isCutOff()) {
      difference = "the recording is cut off after tick " + ticks;
    }
  }

  private Diverged differs(String how) {
    if (!over) {
      over = true;
      difference =
          "in tick "
              + ticks
              + ", at "
              + now / 1_000_000
              + " ms, "
              + how
              + "; recorded: "
              + described(next);
    }
    return new Diverged();
  }

  private static String described(@Nullable Entry entry) {
    return switch (entry) {
      case null -> "nothing";
      case Entry.BytesSent sent -> "sent " + text(sent);
      default -> entry.toString();
    };
  }

  private static String text(Entry.BytesSent sent) {
    return "from " + sent.from() + ": " + new String(sent.head(), StandardCharsets.ISO_8859_1);
  }

  /** The recording has no end: all that there was has been run. */
  private boolean ranOut() {
    if (next == null) {
      over = true;
    }
    return over;
  }

  @Override
  public boolean isReplay() {
    return true;
  }

  @Override
  public boolean isOver() {
    return over;
  }

  @Override
  public boolean countsChecks() {
    return true;
  }

  @Override
  public long tick(long unused) {
    if (!ranOut()) {
      if (next instanceof Entry.Tick tick) {
        now = tick.now();
        ticks++;
        safepoints = 0;
        looks = 0;
        switches = 0;
        tries = 0;
        advance();
      } else {
        differs("the tick is over");
      }
    }
    return now;
  }

  @Override
  public @Nullable Message next(Supplier<Message> unused) {
    if (next instanceof Entry.MessageTaken taken && !over) {
      advance();
      return taken.message();
    }
    return null;
  }

  @Override
  public @Nullable Message nextAtOnce(Supplier<@Nullable Message> unused) {
    if (next instanceof Entry.MessageTakenAtOnce taken && !over) {
      advance();
      return taken.message();
    }
    return null;
  }

  @Override
  // The outcome was recorded at the same query, of the same type.
  @SuppressWarnings("unchecked")
  public <T> @Nullable T query(Outcome.Work<T> unused) throws IOException {
    if (ranOut()) {
      throw new Diverged();
    }
    if (next instanceof Entry.QueryAnswered answered) {
      advance();
      return (T) answered.outcome().get();
    }
    throw differs("the run looks at the outside");
  }

  @Override
  public boolean yieldsToMessages(int turns, boolean news) {
    if (next instanceof Entry.YieldedToMessages yielded && yielded.turns() == turns) {
      advance();
      return true;
    }
    return over;
  }

  @Override
  public boolean hasNewsAtRest(boolean news) {
    if (next instanceof Entry.NewsWaited) {
      advance();
      return true;
    }
    return over;
  }

  @Override
  public StopReason stopReason(StopReason wanted) {
    safepoints++;
    if (next instanceof Entry.JobInterrupted stopped && stopped.safepoint() == safepoints) {
      advance();
      return StopReason.REQUESTED;
    }
    if (next instanceof Entry.JobOverdue overdue && overdue.safepoint() == safepoints) {
      advance();
      return StopReason.OVERDUE;
    }
    if (next instanceof Entry.JobGreedy greedy && greedy.safepoint() == safepoints) {
      advance();
      return StopReason.GREEDY;
    }
    return over ? StopReason.REQUESTED : StopReason.NONE;
  }

  @Override
  public int cutsRound(int jobs, int wanted) {
    if (next instanceof Entry.RoundCut cut && cut.jobs() == jobs) {
      advance();
      return cut.by();
    }
    return over ? 0 : NOBODY;
  }

  @Override
  public boolean refusesSwitch() {
    switches++;
    if (next instanceof Entry.SwitchRefused refused && refused.number() == switches) {
      advance();
      return true;
    }
    return false;
  }

  @Override
  public void switchRefused() {
    if (!ranOut()) {
      differs("the stack of a job cannot be put away");
    }
  }

  @Override
  public boolean triesSwitchAgain(boolean wanted) {
    tries++;
    if (next instanceof Entry.SwitchTriedAgain again && again.look() == tries) {
      advance();
      return true;
    }
    return over;
  }

  @Override
  public boolean misses(boolean gone) {
    looks++;
    if (next instanceof Entry.ObjectMissed missed && missed.look() == looks) {
      advance();
      return true;
    }
    return gone;
  }

  @Override
  public void sent(int from, byte[] bytes) {
    if (ranOut()) {
      return;
    }
    Entry.BytesSent made = Recorder.sending(from, bytes);
    if (next instanceof Entry.BytesSent sent
        && sent.from() == from
        && sent.length() == bytes.length
        && sent.checksum() == made.checksum()
        && Arrays.equals(sent.head(), made.head())) {
      advance();
    } else {
      differs("the run sends " + text(made));
    }
  }

  @Override
  public void missing(Message message) {
    differs("a replay cannot do " + message);
  }

  @Override
  public void end() {
    if (!over && next != null && !(next instanceof Entry.RunEnded)) {
      differs("the run ends");
    }
    over = true;
  }
}
