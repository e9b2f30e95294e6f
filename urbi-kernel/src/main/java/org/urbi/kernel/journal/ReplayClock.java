package org.urbi.kernel.journal;

import org.urbi.kernel.time.Clock;

/** The time of a recorded run. */
public final class ReplayClock implements Clock {
  private final Replay replay;

  public ReplayClock(Replay replay) {
    this.replay = replay;
  }

  @Override
  public long now() {
    return replay.now();
  }

  @Override
  public double startTime() {
    return replay.beginning().startTime();
  }

  @Override
  public boolean isReal() {
    return !replay.beginning().virtualTime();
  }

  @Override
  public void advanceTo(long nanoseconds) {}
}
