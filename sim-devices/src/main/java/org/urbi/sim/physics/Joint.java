package org.urbi.sim.physics;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.physics.JointDescription.Kind;

/**
 * A joint of a {@link PhysicsWorld}. Angles are radians, torques N·m; of sliders metres and
 * newtons.
 */
public final class Joint {
  private final PhysicsWorld world;
  private final JointDescription description;
  private final int number;
  private double angle;
  private double lastAngle;

  Joint(PhysicsWorld world, JointDescription description, int number) {
    this.world = world;
    this.description = description;
    this.number = number;
  }

  public String name() {
    return description.name();
  }

  public Kind kind() {
    return description.kind();
  }

  /** Null for the world. */
  public @Nullable Body first() {
    return description.first();
  }

  public Body second() {
    return description.second();
  }

  /** The smallest position, or -∞. */
  public double low() {
    return description.low();
  }

  /** The greatest position, or ∞. */
  public double high() {
    return description.high();
  }

  /** Whether it has one degree of freedom, along which it can be driven. */
  public boolean canBeDriven() {
    return kind() == Kind.HINGE || kind() == Kind.SLIDER;
  }

  /** How far it has turned or moved. A hinge counts its turns: it goes on beyond π. */
  public double position() {
    requireAxis();
    return kind() == Kind.HINGE ? angle : world.dynamics().jointPosition(number);
  }

  /** In rad/s or m/s. */
  public double velocity() {
    requireAxis();
    return world.dynamics().jointVelocity(number);
  }

  /** The torque or force along the axis that it exerted in the last step. */
  public double load() {
    requireAxis();
    return world.dynamics().jointLoad(number);
  }

  /**
   * Has it driven from now on.
   *
   * @param velocity in rad/s or m/s
   * @param force at most, in N·m or N; 0 for not at all
   */
  public void drive(double velocity, double force) {
    requireAxis();
    EngineLimits.within(velocity, EngineLimits.FASTEST, name() + ": velocity");
    if (!(EngineLimits.within(force, EngineLimits.STRONGEST, name() + ": force") >= 0)) {
      throw new SimulationException(name() + ": force: 0 or more expected, not " + force);
    }
    world.dynamics().setMotor(number, velocity, force);
  }

  /** Has a torque or force act along the axis during the next step. */
  public void push(double force) {
    requireAxis();
    world
        .dynamics()
        .addJointForce(
            number, EngineLimits.within(force, EngineLimits.STRONGEST, name() + ": force"));
  }

  private void requireAxis() {
    if (!canBeDriven()) {
      throw new SimulationException(name() + ": not a hinge or a slider");
    }
  }

  /** Counts the turns of a hinge: engines know angles between -π and π only. */
  void followAngle() {
    if (kind() != Kind.HINGE) {
      return;
    }
    double now = world.dynamics().jointPosition(number);
    double moved = now - lastAngle;
    if (moved > Math.PI) {
      moved -= 2 * Math.PI;
    } else if (moved < -Math.PI) {
      moved += 2 * Math.PI;
    }
    angle += moved;
    lastAngle = now;
  }

  /** Resets the angle: the bodies are where they were when the joint was made. */
  void restart() {
    angle = 0;
    lastAngle = 0;
  }

  @Override
  public String toString() {
    return name();
  }
}
