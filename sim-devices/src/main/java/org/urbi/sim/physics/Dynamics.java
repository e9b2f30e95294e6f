package org.urbi.sim.physics;

import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;

/**
 * The part of a world that an engine computes. Objects are numbered in the order in which they were
 * made, each kind from 0; the frame of a body is at its centre of mass. The caller has checked that
 * all values are finite and in range.
 *
 * <p>The methods are few and move much at a time, since each may be a native call. One thread at a
 * time uses it.
 */
public interface Dynamics extends AutoCloseable {
  /** Instead of a body: the world. */
  int WORLD = -1;

  /** How many numbers {@link #readBody} gives: position, quaternion, velocity, rotation. */
  int STATE_SIZE = 13;

  /** How many numbers a contact has: position, normal, depth. */
  int CONTACT_SIZE = 7;

  /** Of two shapes at most so many contacts are taken. */
  int CONTACTS_PER_PAIR = 8;

  /** Consumes pairs of shapes that may touch. */
  @FunctionalInterface
  interface PairConsumer {
    void near(int firstGeom, int secondGeom);
  }

  /**
   * @param inertia Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the centre of mass
   */
  int createBody(double mass, double[] inertia);

  void readBody(int body, double[] state);

  void placeBody(int body, Vec3 position, Rotation rotation);

  void moveBody(int body, Vec3 velocity, Vec3 spin);

  /** Adds to the force that acts during the next step. */
  void addForce(int body, Vec3 force, Vec3 point);

  /**
   * @param body or {@link #WORLD}
   * @param pose in the frame of the body, or of the world
   */
  int createGeom(int body, Shape shape, Pose pose);

  /** Places a shape that belongs to no body. */
  void placeGeom(int geom, Shape shape, Pose pose);

  int createJoint(JointDescription.Kind kind, int first, int second, Vec3 anchor, Vec3 axis);

  void setLimits(int joint, double low, double high);

  /** Has a joint moved at a velocity by at most a force. */
  void setMotor(int joint, double velocity, double force);

  /** Adds to the force, or torque, that a joint exerts along its axis in the next step. */
  void addJointForce(int joint, double force);

  double jointPosition(int joint);

  double jointVelocity(int joint);

  /** The force, or torque, along the axis that the joint exerted on its second body. */
  double jointLoad(int joint);

  /** Tells all pairs whose bounding boxes meet, of which one at least belongs to a body. */
  void findNearPairs(PairConsumer sink);

  /**
   * Where two shapes touch.
   *
   * @param contacts filled with {@link #CONTACT_SIZE} numbers for each
   * @return how many there are
   */
  int collide(int firstGeom, int secondGeom, double[] contacts);

  /** Makes all contacts that the last {@link #collide} found take part in the next step. */
  void keepContacts(int firstBody, int secondBody, int count, Material material);

  /** Tells all shapes that a ray may meet, as the second ones of the pairs. */
  void findOnRay(Vec3 from, Vec3 direction, double length, PairConsumer sink);

  /**
   * Where the ray of the last {@link #findOnRay} meets a shape.
   *
   * @param contact its depth is the distance from where the ray begins
   */
  boolean meet(int geom, double[] contact);

  /**
   * Goes on by a step, and forgets the contacts.
   *
   * @param number of the step, from which everything random is drawn
   */
  void step(long number);

  /** Frees everything. */
  @Override
  void close();
}
