package org.urbi.kernel;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.UsageMeter;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.memory.Evictable;
import org.urbi.kernel.memory.LobbyGrowth;
import org.urbi.kernel.memory.MemoryUser;

/** What a kernel does when the memory of its process runs out: its lobbies give back theirs. */
final class KernelMemory implements MemoryUser {
  private final Set<Evictable> candidates = ConcurrentHashMap.newKeySet();
  private final LobbyGrowth growth;
  private final KernelLog log;
  private final Consumer<Boolean> onNearlyFull;
  private final Runnable onExhausted;
  private @Nullable Evictable evicted;

  /**
   * @param onNearlyFull told when memory is nearly exhausted, and when it is not any more
   * @param onExhausted called when memory could not be freed
   */
  KernelMemory(
      UsageMeter meter, KernelLog log, Consumer<Boolean> onNearlyFull, Runnable onExhausted) {
    this.growth = new LobbyGrowth(meter, candidates);
    this.log = log;
    this.onNearlyFull = onNearlyFull;
    this.onExhausted = onExhausted;
  }

  void add(Evictable candidate) {
    candidates.add(candidate);
  }

  void remove(Evictable candidate) {
    candidates.remove(candidate);
  }

  @Override
  public void memoryScarce(boolean scarce) {
    if (scarce) {
      growth.measure();
    } else {
      growth.forget();
    }
  }

  @Override
  public double growth() {
    return remaining() == null ? growth.largest() : Double.POSITIVE_INFINITY;
  }

  /**
   * Ends the jobs of the lobby that has grown most, and tells its client. If that was not enough,
   * the next call disconnects that client, which frees the lobby's objects; the one after that
   * turns to the next lobby.
   */
  @Override
  public void relieve() {
    Evictable before = remaining();
    if (before != null) {
      evicted = null;
      before.close();
      tell("letting " + before.description() + " go");
      return;
    }
    evicted = growth.next();
    if (evicted != null) {
      evicted.evict(Problem.MEMORY_EXHAUSTED.text());
      tell("ending what is done for " + evicted.description());
    }
  }

  /** Whose jobs were ended before, if it can be let go now. */
  private @Nullable Evictable remaining() {
    Evictable before = evicted;
    return before != null && candidates.contains(before) && !before.stays() ? before : null;
  }

  @Override
  public void memoryNearlyFull(boolean full) {
    onNearlyFull.accept(full);
  }

  @Override
  public void memoryExhausted() {
    onExhausted.run();
  }

  private void tell(String done) {
    log.write("urbi: memory is nearly exhausted, " + done);
  }
}
