package org.urbi.sim.device;

import org.urbi.sim.SimulationException;

/** How simulated time follows another clock. All times are in seconds. */
final class Pace {
  private static final double FASTEST = 10;

  /** Simulated time at the origin, if none had been lost. */
  private double base;

  /** Of the other clock: when this pace began. */
  private double origin;

  private double lost;
  private double speed = 1;
  private boolean paused;

  /** Simulated time begins now, with 0. */
  Pace(double now) {
    origin = now;
  }

  /** How far simulated time should be by now. */
  double goal(double now) {
    return base + passed(now) - lost;
  }

  /** Since this pace began. */
  private double passed(double now) {
    return (now - origin) * (paused ? 0 : speed);
  }

  /**
   * Gives up some seconds that the machine was too slow for; a negative number takes some back.
   *
   * @return all the seconds that have been given up until now
   */
  double lose(double seconds) {
    lost += seconds;
    return lost;
  }

  boolean isPaused() {
    return paused;
  }

  /** How many simulated seconds there are in one, unless it is paused. */
  double speed() {
    return speed;
  }

  /** Halts or goes on from now on. */
  void pause(double now, boolean wanted) {
    rebase(now);
    paused = wanted;
  }

  /**
   * Goes on at another speed from now on.
   *
   * @throws SimulationException if it is not above 0, or more than 10
   */
  void go(double now, double wanted) {
    if (!(wanted > 0 && wanted <= FASTEST)) {
      throw new SimulationException(
          "speed: above 0 and at most " + FASTEST + " expected, not " + wanted);
    }
    rebase(now);
    speed = wanted;
  }

  private void rebase(double now) {
    base += passed(now);
    origin = now;
  }
}
