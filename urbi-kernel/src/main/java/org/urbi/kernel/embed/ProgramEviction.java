package org.urbi.kernel.embed;

import static java.util.Objects.requireNonNull;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.memory.Evictable;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.object.UrbiObject;

/**
 * The embedding program, as one of those who use the memory. It may be asked to give back what it
 * has taken while the request that took it ends by itself, and the program asks for something else:
 * that goes on.
 */
final class ProgramEviction implements Evictable {
  private final Scheduler scheduler;
  private final Supplier<@Nullable UrbiLobby> lobby;

  /** The number of the job of the last request that has begun. */
  private volatile long lastBegun;

  /** What was last decided; null if nothing. */
  private volatile Message.@Nullable ProgramEvicted decided;

  /**
   * @param lobby that of the program, once there is one
   */
  ProgramEviction(Scheduler scheduler, Supplier<@Nullable UrbiLobby> lobby) {
    this.scheduler = scheduler;
    this.lobby = lobby;
  }

  @Override
  public @Nullable Budget budget() {
    UrbiLobby of = lobby.get();
    return of == null ? null : of.budget();
  }

  @Override
  public String description() {
    return Problem.EMBEDDING_PROGRAM.text();
  }

  @Override
  public void evict(String why) {
    var now = new Message.ProgramEvicted(lastBegun, why);
    decided = now;
    scheduler.interruptions().request(own(), job -> isConcerned(job, now.last()));
    scheduler.inbox().post(now);
  }

  @Override
  public boolean isAtWork() {
    Budget of = budget();
    return of != null && of.used(Resource.JOBS) > 0;
  }

  @Override
  public boolean stays() {
    return true;
  }

  @Override
  public void close() {
    throw new UnsupportedOperationException("it stays");
  }

  private UrbiLobby own() {
    return requireNonNull(lobby.get(), "who has no lobby has taken nothing");
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** The code of a request begins, in that job. */
  void begins(Job job) {
    lastBegun = Math.max(lastBegun, job.number());
  }

  /** Ends what was begun before that was decided. */
  void obey(Message.ProgramEvicted order, UrbiObject nothing) {
    UrbiLobby of = own();
    tag().stop(scheduler, nothing, order.last());
    Diagnostics.error(of.output(), Problem.EVICTED.text(order.reason()));
    // If there was no memory for that, its jobs must not take more until there is.
    scheduler.interruptions().clear(of);
  }

  /** Why the request with the job of that number was ended; null if that was not to free memory. */
  @Nullable String reasonFor(long job) {
    Message.ProgramEvicted last = decided;
    return last != null && job <= last.last() ? last.reason() : null;
  }

  private TagState tag() {
    return own().connectionTag().state();
  }

  private boolean isConcerned(Job job, long last) {
    return job.number() <= last || tag().isStopped(job, last);
  }
}
