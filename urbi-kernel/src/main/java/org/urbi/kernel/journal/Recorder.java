package org.urbi.kernel.journal;

import java.io.IOException;
import java.util.Arrays;
import java.util.function.Supplier;
import java.util.zip.CRC32C;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;

/** Writes down a run. */
public final class Recorder implements Journal {
  /** So many bytes of what goes out at once are written down; of more, a checksum of all. */
  private static final int HEAD = 1 << 12;

  private final RecordingWriter file;
  private long safepoints;
  private long looks;
  private long switches;
  private long tries;
  private boolean ended;

  public Recorder(Entry.RunStarted beginning, RecordingWriter file) {
    this.file = file;
    file.write(beginning);
  }

  @Override
  public boolean countsChecks() {
    return true;
  }

  @Override
  public long tick(long now) {
    safepoints = 0;
    looks = 0;
    switches = 0;
    tries = 0;
    file.write(new Entry.Tick(now));
    return now;
  }

  @Override
  public Message next(Supplier<Message> inbox) {
    Message message = inbox.get();
    if (message != null) {
      file.write(new Entry.MessageTaken(message));
    }
    return message;
  }

  @Override
  public @Nullable Message nextAtOnce(Supplier<@Nullable Message> inbox) {
    Message message = inbox.get();
    if (message != null) {
      file.write(new Entry.MessageTakenAtOnce(message));
    }
    return message;
  }

  @Override
  public <T> @Nullable T query(Outcome.Work<T> work) throws IOException {
    Outcome outcome = Outcome.of(work);
    file.write(new Entry.QueryAnswered(outcome));
    return outcome.get();
  }

  @Override
  public boolean yieldsToMessages(int turns, boolean news) {
    if (news) {
      file.write(new Entry.YieldedToMessages(turns));
    }
    return news;
  }

  @Override
  public boolean hasNewsAtRest(boolean news) {
    if (news) {
      file.write(new Entry.NewsWaited());
    }
    return news;
  }

  @Override
  public StopReason stopReason(StopReason wanted) {
    safepoints++;
    if (wanted == StopReason.REQUESTED) {
      file.write(new Entry.JobInterrupted(safepoints));
    } else if (wanted == StopReason.OVERDUE) {
      file.write(new Entry.JobOverdue(safepoints));
    } else if (wanted == StopReason.GREEDY) {
      file.write(new Entry.JobGreedy(safepoints));
    }
    return wanted;
  }

  @Override
  public int cutsRound(int jobs, int wanted) {
    if (wanted != NOBODY) {
      file.write(new Entry.RoundCut(jobs, wanted));
    }
    return wanted;
  }

  @Override
  public boolean refusesSwitch() {
    switches++;
    return false;
  }

  @Override
  public void switchRefused() {
    file.write(new Entry.SwitchRefused(switches));
  }

  @Override
  public boolean triesSwitchAgain(boolean wanted) {
    tries++;
    if (wanted) {
      file.write(new Entry.SwitchTriedAgain(tries));
    }
    return wanted;
  }

  @Override
  public boolean misses(boolean gone) {
    looks++;
    if (gone) {
      file.write(new Entry.ObjectMissed(looks));
    }
    return gone;
  }

  @Override
  public void sent(int from, byte[] bytes) {
    file.write(sending(from, bytes));
  }

  static Entry.BytesSent sending(int from, byte[] bytes) {
    CRC32C checksum = new CRC32C();
    checksum.update(bytes);
    return new Entry.BytesSent(
        from,
        bytes.length,
        Arrays.copyOf(bytes, Math.min(bytes.length, HEAD)),
        (int) checksum.getValue());
  }

  @Override
  public void idle() {
    file.flush();
  }

  @Override
  public void end() {
    if (!ended) {
      ended = true;
      file.write(new Entry.RunEnded());
      file.close();
    }
  }
}
