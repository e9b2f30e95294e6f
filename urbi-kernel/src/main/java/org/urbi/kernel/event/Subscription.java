package org.urbi.kernel.event;

import org.urbi.kernel.job.Job;

/** A subscriber to the emissions of an event. */
public interface Subscription {
  /**
   * An emission begins.
   *
   * @param emitter the job which emits; code may be evaluated in it
   */
  void begin(Emission emission, Job emitter);

  /** An emission has ended for which {@link #begin} was called. */
  void end(Emission emission, Job emitter);
}
