package org.urbi.sim.physics;

import java.util.List;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Vec3;

/** A rigid body of a {@link PhysicsWorld}. */
public final class Body {
  /** Where velocity and spin begin in the state. */
  private static final int FIRST_SPEED = 7;

  private final PhysicsWorld world;
  private final String name;
  private final List<BodyDescription.Part> parts;
  private final int index;
  private final int number;
  private final int firstGeom;

  /** The centre of mass in the frame of the body. */
  private final Vec3 centre;

  private final double mass;

  private final double[] state = new double[Dynamics.STATE_SIZE];
  private final double[] remembered = new double[Dynamics.STATE_SIZE];
  private long stateOf = -1;
  private Pose pose;

  /** How the world began, for {@link #restart}. */
  private Pose firstPose;

  private Vec3 firstVelocity = Vec3.ZERO;
  private Vec3 firstSpin = Vec3.ZERO;

  Body(
      PhysicsWorld world,
      BodyDescription description,
      int index,
      int number,
      int firstGeom,
      Vec3 centre) {
    this.world = world;
    this.name = description.name();
    this.parts = description.parts();
    this.pose = description.pose();
    this.firstPose = pose;
    this.mass = description.mass();
    this.index = index;
    this.number = number;
    this.firstGeom = firstGeom;
    this.centre = centre;
  }

  public String name() {
    return name;
  }

  /** What it consists of, in its own frame. */
  public List<BodyDescription.Part> parts() {
    return parts;
  }

  /** Whether it never moves by itself. */
  public boolean isFixed() {
    return number == Dynamics.WORLD;
  }

  /** In kg; 0 for one that is fixed. */
  public double mass() {
    return mass;
  }

  /** Which one of the world it is. */
  int index() {
    return index;
  }

  /** Which one of the engine it is, or {@link Dynamics#WORLD}. */
  int number() {
    return number;
  }

  private void update() {
    if (stateOf == world.version() || isFixed()) {
      return;
    }
    world.dynamics().readBody(number, state);
    Rotation rotation = new Rotation(state[3], state[4], state[5], state[6]);
    Vec3 position = new Vec3(state[0], state[1], state[2]);
    pose = new Pose(position.minus(rotation.apply(centre)), rotation);
    stateOf = world.version();
  }

  /** Where its frame is. */
  public Pose pose() {
    update();
    return pose;
  }

  /** Where its centre of mass is. */
  public Vec3 centreOfMass() {
    return pose().apply(centre);
  }

  /** The velocity of its centre of mass, in m/s. */
  public Vec3 velocity() {
    update();
    return new Vec3(state[7], state[8], state[9]);
  }

  /** How it turns, in rad/s, about the axes of the world. */
  public Vec3 spin() {
    update();
    return new Vec3(state[10], state[11], state[12]);
  }

  /** The velocity of a point of it, given in its own frame. */
  public Vec3 velocityAt(Vec3 point) {
    return velocity().plus(spin().cross(pose().rotation().apply(point.minus(centre))));
  }

  /**
   * Puts it somewhere else, as it is.
   *
   * @throws SimulationException if the place is not finite, or too far away
   */
  public void place(Pose newPose) {
    if (!newPose.isFinite()) {
      throw new SimulationException(name + ": the place is not finite");
    }
    EngineLimits.within(newPose.position(), EngineLimits.FARTHEST, name + ": the place");
    if (isFixed()) {
      for (int i = 0; i < parts.size(); i++) {
        BodyDescription.Part part = parts.get(i);
        world.dynamics().placeGeom(firstGeom + i, part.shape(), newPose.apply(part.pose()));
      }
      pose = newPose;
    } else {
      Pose unit = new Pose(newPose.position(), newPose.rotation().normalized());
      world.dynamics().placeBody(number, unit.apply(centre), unit.rotation());
    }
    world.changed();
  }

  /**
   * Gives it a velocity, in m/s, and a rotation about the axes of the world, in rad/s.
   *
   * @throws SimulationException if one is not finite or too fast, or if the body is fixed
   */
  public void move(Vec3 velocity, Vec3 spin) {
    EngineLimits.within(velocity, EngineLimits.FASTEST, name + ": the velocity");
    EngineLimits.within(spin, EngineLimits.FASTEST, name + ": the spin");
    requireFree();
    world.dynamics().moveBody(number, velocity, spin);
    world.changed();
  }

  /**
   * Has a force, in newtons, act during the next step at a point of the world.
   *
   * @throws SimulationException if it is not finite or too strong, or if the body is fixed
   */
  public void push(Vec3 force, Vec3 point) {
    EngineLimits.within(force, EngineLimits.STRONGEST, name + ": the force");
    EngineLimits.within(point, 2 * EngineLimits.FARTHEST, name + ": the point");
    requireFree();
    world.dynamics().addForce(number, force, point);
  }

  /** Keeps how it is now, for {@link #restore}. */
  void remember() {
    update();
    System.arraycopy(state, 0, remembered, 0, state.length);
  }

  /** Puts it where it was when it was remembered, at rest. */
  void restore() {
    if (!isFixed()) {
      double[] s = remembered;
      Rotation rotation = new Rotation(s[3], s[4], s[5], s[6]).normalized();
      world.dynamics().placeBody(number, new Vec3(s[0], s[1], s[2]), rotation);
      world.dynamics().moveBody(number, Vec3.ZERO, Vec3.ZERO);
      world.changed();
    }
  }

  /** Keeps how it is now, for {@link #restart}. */
  void keepStart() {
    firstPose = pose();
    if (!isFixed()) {
      firstVelocity = velocity();
      firstSpin = spin();
    }
  }

  /** Has it be again as it was when that was kept. */
  void restart() {
    place(firstPose);
    if (!isFixed()) {
      move(firstVelocity, firstSpin);
    }
  }

  /**
   * Refuses to go on with what cannot be: the next step could overflow.
   *
   * @throws SimulationException if it is too fast or too far away
   */
  void requireSane() {
    update();
    for (int i = FIRST_SPEED; i < state.length; i++) {
      if (!(Math.abs(state[i]) < EngineLimits.FASTEST)) {
        throw diverged("moves or turns faster than " + EngineLimits.FASTEST + " m/s or rad/s");
      }
    }
    for (int i = 0; i < FIRST_SPEED; i++) {
      if (!(Math.abs(state[i]) < 2 * EngineLimits.FARTHEST)) {
        throw diverged("is farther away than " + 2 * EngineLimits.FARTHEST + " m");
      }
    }
  }

  private SimulationException diverged(String how) {
    return new SimulationException(
        name
            + ": "
            + how
            + ": the simulation has diverged; try a smaller step, or the solver 'quick'");
  }

  private void requireFree() {
    if (isFixed()) {
      throw new SimulationException(name + ": does not move: it has no mass");
    }
  }

  @Override
  public String toString() {
    return name;
  }
}
