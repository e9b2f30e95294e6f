package org.urbi.kernel.job;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.object.UrbiObject;

/**
 * The lobbies whose running code is to end although it never lets others run, so that no message
 * can reach them. A flag only: who wants that posts a message besides, which {@linkplain #clear
 * takes the flag back} when its turn comes.
 */
public final class Interruptions {
  private final Set<UrbiObject> lobbies = ConcurrentHashMap.newKeySet();
  private final Journal journal;
  private final boolean counted;
  private volatile boolean wanted;
  private volatile Runnable changed = () -> {};

  Interruptions(Journal journal) {
    this.journal = journal;
    this.counted = journal.counts();
    this.wanted = counted;
  }

  /** Has the job end that is running for that lobby, if there is one; from any thread. */
  public void want(UrbiObject lobby) {
    lobbies.add(lobby);
    wanted = true;
    changed.run();
  }

  /**
   * Sets who is told, on whatever thread, when there may be some where there were none, or back.
   */
  public void whenChanged(Runnable listener) {
    changed = listener;
    listener.run();
  }

  /**
   * Whether there is any, or it counts how often that is asked; code looks at this in each turn of
   * a loop, and at each call.
   */
  public boolean areWanted() {
    return wanted;
  }

  /** Whether the job that is running for that lobby is to end; that is so once. */
  boolean take(UrbiObject lobby) {
    if (!journal.stops(lobby != null && lobbies.contains(lobby))) {
      return false;
    }
    clear(lobby);
    return true;
  }

  /** Nobody is to be interrupted any more; on the kernel thread. */
  public void clear(UrbiObject lobby) {
    lobbies.remove(lobby);
    wanted = counted;
    if (!lobbies.isEmpty()) {
      // Others wait, or one has come between the two.
      wanted = true;
    }
    changed.run();
  }
}
