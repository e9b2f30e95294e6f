package org.urbi.kernel.job;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * The stops of tags and of groups of jobs. Very large ones are made in pieces, one in a tick, so
 * that others need not wait. Nobody notices but by the time it takes: from the beginning no job
 * that is to be stopped executes anything but its end, and no handler reacts. In simulated time
 * nobody waits, and there are no pieces.
 */
final class Stops {
  /** How many scopes, handlers and jobs make a piece, which takes less than a millisecond. */
  private static final int PIECE = 500;

  private final Scheduler scheduler;

  /** The stops that are done in pieces, in the order in which they began. */
  private final Deque<Stop> inPieces = new ArrayDeque<>();

  private int begun;

  Stops(Scheduler scheduler) {
    this.scheduler = scheduler;
  }

  /** How many have been made in pieces, those that are not over included. */
  int begun() {
    return begun;
  }

  /** Whether none is to be continued. */
  boolean isEmpty() {
    return inPieces.isEmpty();
  }

  /** Begins one; it is over at once, unless it has to end very much. */
  void begin(Stop stop) {
    if (stop.goOn(scheduler.clock().isReal() ? PIECE : Integer.MAX_VALUE)) {
      return;
    }
    inPieces.add(stop);
    stop.beginPieces(++begun);
    Job running = scheduler.running();
    if (running != null) {
      running.meetStops();
    }
  }

  /** Makes the next piece. */
  void goOn() {
    Stop first = inPieces.peek();
    if (first != null && isOver(first)) {
      inPieces.remove();
      first.endPieces();
    }
  }

  /** A handler that fails must not keep the others. */
  private boolean isOver(Stop stop) {
    try {
      return stop.goOn(PIECE);
    } catch (OutOfMemoryError e) {
      throw e;
    } catch (Throwable failure) {
      scheduler.report(null, failure);
      return false;
    }
  }

  /** Ends what a job executes, if one of those wants it that began later than that one. */
  void meet(Job job, int last) {
    for (Stop stop : inPieces) {
      if (stop.number() > last) {
        stop.reach(job);
      }
    }
  }
}
