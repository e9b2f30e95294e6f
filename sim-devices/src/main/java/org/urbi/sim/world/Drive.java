package org.urbi.sim.world;

import org.urbi.sim.SimulationException;
import org.urbi.sim.physics.EngineLimits;
import org.urbi.sim.physics.Joint;
import org.urbi.sim.physics.JointDescription;

/**
 * The motor of a joint and its controller. It is driven to a position by the speed {@code P·e +
 * I·∫e dt + D·de/dt}, at most {@link #maxSpeed}, where e is the remaining distance; or at a speed.
 * The joint holds that speed with at most its greatest force.
 */
public final class Drive {
  /** What controls the motor. */
  public enum Control {
    POSITION,
    SPEED
  }

  private final Joint joint;
  private final Control control;
  private final double maxForce;
  private double maxSpeed;
  private double p;
  private double i;
  private double d;
  private double load = 1;
  private double target;
  private double integral;
  private double lastError;

  Drive(Joint joint, Control control, double maxForce, double maxSpeed, double[] gains) {
    this.joint = joint;
    this.control = control;
    this.maxForce = EngineLimits.within(maxForce, EngineLimits.STRONGEST, name() + ": force");
    setMaxSpeed(maxSpeed);
    setGains(gains[0], gains[1], gains[2]);
  }

  public Joint joint() {
    return joint;
  }

  public String name() {
    return joint.name();
  }

  public Control control() {
    return control;
  }

  /** In N·m or N. */
  public double maxForce() {
    return maxForce;
  }

  /** In rad/s or m/s. */
  public double maxSpeed() {
    return maxSpeed;
  }

  /**
   * @throws SimulationException if it is negative or not finite
   */
  public void setMaxSpeed(double speed) {
    if (!(EngineLimits.within(speed, EngineLimits.FASTEST, name() + ": speed") >= 0)) {
      throw new SimulationException(name() + ": speed: 0 or more expected, not " + speed);
    }
    maxSpeed = speed;
  }

  public double p() {
    return p;
  }

  public double i() {
    return i;
  }

  public double d() {
    return d;
  }

  /**
   * In 1/s, 1/s² and 1.
   *
   * @throws SimulationException if one is negative or not finite
   */
  public void setGains(double newP, double newI, double newD) {
    for (double gain : new double[] {newP, newI, newD}) {
      if (!(EngineLimits.within(gain, EngineLimits.STRONGEST, name() + ": gain") >= 0)) {
        throw new SimulationException(name() + ": gain: 0 or more expected, not " + gain);
      }
    }
    p = newP;
    i = newI;
    d = newD;
    integral = 0;
  }

  /** How much of its force it may use. */
  public double load() {
    return load;
  }

  /**
   * How much of its force it may use, from 0 to 1.
   *
   * @throws SimulationException if it is not between these
   */
  public void setLoad(double share) {
    if (!(share >= 0 && share <= 1)) {
      throw new SimulationException(name() + ": load: between 0 and 1 expected, not " + share);
    }
    load = share;
  }

  /** The position, or the speed, that it has. */
  public double sensed() {
    return control == Control.POSITION ? joint.position() : joint.velocity();
  }

  /** In which {@link #sensed} and {@link #target} are. */
  public String unit() {
    String length = joint.kind() == JointDescription.Kind.HINGE ? "rad" : "m";
    return control == Control.POSITION ? length : length + "/s";
  }

  /** The position, or the speed, that it is to reach. */
  public double target() {
    return target;
  }

  /**
   * What it is to reach: a position within the limits of the joint, or a speed up to the greatest
   * one.
   *
   * @return what it makes of it: the nearest that it can reach
   * @throws SimulationException if it is not a finite number
   */
  public double setTarget(double wanted) {
    EngineLimits.within(wanted, EngineLimits.FARTHEST, name() + ": target");
    double low = control == Control.POSITION ? joint.low() : -maxSpeed;
    double high = control == Control.POSITION ? joint.high() : maxSpeed;
    target = Math.clamp(wanted, low, high);
    return target;
  }

  /** Forgets its target, and what it has come from. */
  void restart() {
    target = 0;
    integral = 0;
    lastError = 0;
  }

  /** Has the motor run during the next step. */
  void beforeStep(double step) {
    double speed = target;
    if (control == Control.POSITION) {
      double error = target - joint.position();
      integral += error * step;
      speed = p * error + i * integral + d * (error - lastError) / step;
      lastError = error;
      if (Math.abs(speed) > maxSpeed) {
        // What cannot be carried out is not to be added up.
        integral -= error * step;
      }
    }
    joint.drive(Math.clamp(speed, -maxSpeed, maxSpeed), load * maxForce);
  }
}
