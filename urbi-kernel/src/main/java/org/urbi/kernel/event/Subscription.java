package org.urbi.kernel.event;

import org.urbi.kernel.job.Job;

/** Somebody who hears of the emissions of an event. */
public interface Subscription {
  /**
   * An emission begins.
   *
   * @param emitter the job which emits; code may be evaluated in it
   */
  void begin(Emission emission, Job emitter);

  /** An emission that was begun is over. */
  void end(Emission emission, Job emitter);
}
