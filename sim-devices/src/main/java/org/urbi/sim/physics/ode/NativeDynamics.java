package org.urbi.sim.physics.ode;

import static java.util.Objects.requireNonNull;
import static org.urbi.sim.physics.ode.OdeLibrary.*;
import static org.urbi.sim.physics.ode.StepCalls.*;

import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.Pointer;
import java.nio.DoubleBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.Dynamics;
import org.urbi.sim.physics.JointDescription;
import org.urbi.sim.physics.Material;
import org.urbi.sim.physics.PhysicsSettings;

/** A world of libode. */
final class NativeDynamics implements Dynamics {
  /** What does not move collides only with what does. */
  private static final long FIXED = 1;

  private static final long MOVING = 2;

  /** {@code dSAP_AXES_XYZ}: along which axes shapes are sorted. */
  private static final int AXES = 0 | 1 << 2 | 2 << 4;

  private static final int MASS_SIZE = 136;
  private static final int FEEDBACK_SIZE = 128;

  /** A body, and where ODE keeps its state: it stays there as long as the body lives. */
  private record NativeBody(
      long id,
      DoubleBuffer position,
      DoubleBuffer rotation,
      DoubleBuffer velocity,
      DoubleBuffer spin) {}

  private record NativeJoint(
      long id, JointDescription.Kind kind, int movedBody, Memory memory, DoubleBuffer feedback) {}

  private final PhysicsSettings settings;
  private final long world;
  private final long space;
  private final long contactGroup;
  private final long ray;
  private final ContactMemory contacts = new ContactMemory();
  private final Memory mass = new Memory(MASS_SIZE);
  private final List<NativeBody> bodies = new ArrayList<>();
  private final List<Long> geoms = new ArrayList<>();
  private final Map<Long, Integer> geomNumbers = new HashMap<>();
  private final List<NativeJoint> joints = new ArrayList<>();

  // Held here since the library keeps but their addresses.
  private final NearCallback pairCallback = new NearCallback(this::foundPair);
  private final NearCallback rayCallback = new NearCallback(this::foundOnRay);
  private @Nullable PairConsumer sink;

  NativeDynamics(PhysicsSettings settings) {
    this.settings = settings;
    world = dWorldCreate();
    space = dSweepAndPruneSpaceCreate(0, AXES);
    contactGroup = dJointGroupCreate(0);
    ray = dCreateRay(0, 1);
    Vec3 g = settings.gravity();
    dWorldSetGravity(world, g.x(), g.y(), g.z());
    dWorldSetCFM(world, PhysicsSettings.SOFTNESS);
    dWorldSetQuickStepNumIterations(world, settings.iterations());
  }

  // ------------------------------------------------------------------ bodies

  @Override
  public int createBody(double kilograms, double[] inertia) {
    long id = dBodyCreate(world);
    dMassSetParameters(
        mass,
        kilograms,
        0,
        0,
        0,
        inertia[0],
        inertia[1],
        inertia[2],
        inertia[3],
        inertia[4],
        inertia[5]);
    dBodySetMass(id, mass);
    bodies.add(
        new NativeBody(
            id,
            doubles(dBodyGetPosition(id), 3),
            doubles(dBodyGetQuaternion(id), 4),
            doubles(dBodyGetLinearVel(id), 3),
            doubles(dBodyGetAngularVel(id), 3)));
    return bodies.size() - 1;
  }

  private static DoubleBuffer doubles(Pointer pointer, int count) {
    return pointer.getByteBuffer(0, 8L * count).asDoubleBuffer();
  }

  private long bodyId(int body) {
    return body == WORLD ? 0 : bodies.get(body).id();
  }

  @Override
  public void readBody(int body, double[] state) {
    NativeBody b = bodies.get(body);
    b.position().get(0, state, 0, 3);
    b.rotation().get(0, state, 3, 4);
    b.velocity().get(0, state, 7, 3);
    b.spin().get(0, state, 10, 3);
  }

  @Override
  public void placeBody(int body, Vec3 p, Rotation rotation) {
    dBodySetPosition(bodyId(body), p.x(), p.y(), p.z());
    dBodySetQuaternion(bodyId(body), quaternion(rotation));
  }

  private static double[] quaternion(Rotation r) {
    return new double[] {r.w(), r.x(), r.y(), r.z()};
  }

  @Override
  public void moveBody(int body, Vec3 v, Vec3 spin) {
    dBodySetLinearVel(bodyId(body), v.x(), v.y(), v.z());
    dBodySetAngularVel(bodyId(body), spin.x(), spin.y(), spin.z());
  }

  @Override
  public void addForce(int body, Vec3 f, Vec3 p) {
    dBodyAddForceAtPos(bodyId(body), f.x(), f.y(), f.z(), p.x(), p.y(), p.z());
  }

  // ------------------------------------------------------------------ shapes

  @Override
  public int createGeom(int body, Shape shape, Pose pose) {
    long id =
        switch (shape) {
          case Shape.Sphere s -> dCreateSphere(space, s.radius());
          case Shape.Box b -> dCreateBox(space, b.x(), b.y(), b.z());
          case Shape.Cylinder c -> dCreateCylinder(space, c.radius(), c.length());
          case Shape.Capsule c -> dCreateCapsule(space, c.radius(), c.length());
          case Shape.Plane p -> dCreatePlane(space, 0, 0, 1, 0);
        };
    geoms.add(id);
    geomNumbers.put(id, geoms.size() - 1);
    if (body == WORLD) {
      dGeomSetCategoryBits(id, FIXED);
      dGeomSetCollideBits(id, MOVING);
      placeGeom(geoms.size() - 1, shape, pose);
    } else {
      dGeomSetCategoryBits(id, MOVING);
      dGeomSetCollideBits(id, FIXED | MOVING);
      dGeomSetBody(id, bodyId(body));
      Vec3 p = pose.position();
      dGeomSetOffsetPosition(id, p.x(), p.y(), p.z());
      dGeomSetOffsetQuaternion(id, quaternion(pose.rotation()));
    }
    return geoms.size() - 1;
  }

  @Override
  public void placeGeom(int geom, Shape shape, Pose pose) {
    long id = geoms.get(geom);
    Vec3 p = pose.position();
    if (shape instanceof Shape.Plane) {
      Vec3 up = pose.rotation().apply(Vec3.Z);
      dGeomPlaneSetParams(id, up.x(), up.y(), up.z(), up.dot(p));
    } else {
      dGeomSetPosition(id, p.x(), p.y(), p.z());
      dGeomSetQuaternion(id, quaternion(pose.rotation()));
    }
  }

  // ------------------------------------------------------------------ joints

  @Override
  public int createJoint(JointDescription.Kind kind, int first, int second, Vec3 a, Vec3 axis) {
    long id =
        switch (kind) {
          case FIXED -> dJointCreateFixed(world, 0);
          case HINGE -> dJointCreateHinge(world, 0);
          case SLIDER -> dJointCreateSlider(world, 0);
          case BALL -> dJointCreateBall(world, 0);
        };
    // For ODE, it is the first body that moves with respect to the second.
    dJointAttach(id, bodyId(second), bodyId(first));
    switch (kind) {
      case FIXED -> dJointSetFixed(id);
      case HINGE -> {
        dJointSetHingeAnchor(id, a.x(), a.y(), a.z());
        dJointSetHingeAxis(id, axis.x(), axis.y(), axis.z());
      }
      case SLIDER -> dJointSetSliderAxis(id, axis.x(), axis.y(), axis.z());
      case BALL -> dJointSetBallAnchor(id, a.x(), a.y(), a.z());
    }
    Memory memory = new Memory(FEEDBACK_SIZE);
    memory.clear();
    dJointSetFeedback(id, memory);
    joints.add(new NativeJoint(id, kind, second, memory, doubles(memory, FEEDBACK_SIZE / 8)));
    return joints.size() - 1;
  }

  private void setParameter(int joint, int parameter, double value) {
    NativeJoint j = joints.get(joint);
    if (j.kind() == JointDescription.Kind.HINGE) {
      dJointSetHingeParam(j.id(), parameter, value);
    } else {
      dJointSetSliderParam(j.id(), parameter, value);
    }
  }

  @Override
  public void setLimits(int joint, double low, double high) {
    setParameter(joint, PARAM_LO_STOP, low);
    setParameter(joint, PARAM_HI_STOP, high);
  }

  @Override
  public void setMotor(int joint, double velocity, double force) {
    setParameter(joint, PARAM_VEL, velocity);
    setParameter(joint, PARAM_FMAX, force);
  }

  @Override
  public void addJointForce(int joint, double force) {
    NativeJoint j = joints.get(joint);
    if (j.kind() == JointDescription.Kind.HINGE) {
      dJointAddHingeTorque(j.id(), force);
    } else {
      dJointAddSliderForce(j.id(), force);
    }
  }

  @Override
  public double jointPosition(int joint) {
    NativeJoint j = joints.get(joint);
    return j.kind() == JointDescription.Kind.HINGE
        ? dJointGetHingeAngle(j.id())
        : dJointGetSliderPosition(j.id());
  }

  @Override
  public double jointVelocity(int joint) {
    NativeJoint j = joints.get(joint);
    return j.kind() == JointDescription.Kind.HINGE
        ? dJointGetHingeAngleRate(j.id())
        : dJointGetSliderPositionRate(j.id());
  }

  @Override
  public double jointLoad(int joint) {
    NativeJoint j = joints.get(joint);
    Vec3 force = vector(j.feedback(), 0);
    double[] numbers = new double[4];
    if (j.kind() == JointDescription.Kind.SLIDER) {
      dJointGetSliderAxis(j.id(), numbers);
      return force.dot(new Vec3(numbers[0], numbers[1], numbers[2]));
    }
    dJointGetHingeAxis(j.id(), numbers);
    Vec3 axis = new Vec3(numbers[0], numbers[1], numbers[2]);
    dJointGetHingeAnchor(j.id(), numbers);
    Vec3 anchor = new Vec3(numbers[0], numbers[1], numbers[2]);
    Vec3 arm = anchor.minus(vector(bodies.get(j.movedBody()).position(), 0));
    // The torque is given about the centre of mass; what the force does there is not the joint's.
    return vector(j.feedback(), 4).minus(arm.cross(force)).dot(axis);
  }

  private static Vec3 vector(DoubleBuffer numbers, int at) {
    return new Vec3(numbers.get(at), numbers.get(at + 1), numbers.get(at + 2));
  }

  // ------------------------------------------------------------------ collisions

  @Override
  public void findNearPairs(PairConsumer pairs) {
    sink = pairs;
    dSpaceCollide(space, 0, pairCallback.address());
    pairCallback.check();
  }

  private PairConsumer sink() {
    return requireNonNull(sink, "the library calls back while it looks for pairs");
  }

  private int number(long geom) {
    return requireNonNull(geomNumbers.get(geom), "the library knows no geom of another world");
  }

  private void foundPair(long first, long second) {
    sink().near(number(first), number(second));
  }

  @Override
  public int collide(int first, int second, double[] numbers) {
    int count =
        dCollide(
            geoms.get(first),
            geoms.get(second),
            CONTACTS_PER_PAIR,
            contacts.geometry(),
            ContactMemory.SIZE);
    for (int i = 0; i < count; i++) {
      contacts.read(i, numbers);
    }
    return count;
  }

  @Override
  public void keepContacts(int firstBody, int secondBody, int count, Material material) {
    long first = bodyId(firstBody);
    long second = bodyId(secondBody);
    for (int i = 0; i < count; i++) {
      contacts.setSurface(i, material);
      dJointAttach(dJointCreateContact(world, contactGroup, contacts.contact(i)), first, second);
    }
  }

  @Override
  public void findOnRay(Vec3 from, Vec3 direction, double length, PairConsumer pairs) {
    sink = pairs;
    dGeomRaySetLength(ray, length);
    dGeomRaySet(ray, from.x(), from.y(), from.z(), direction.x(), direction.y(), direction.z());
    dSpaceCollide2(ray, space, 0, rayCallback.address());
    rayCallback.check();
  }

  private void foundOnRay(long first, long second) {
    sink().near(WORLD, number(first == ray ? second : first));
  }

  @Override
  public boolean meet(int geom, double[] contact) {
    boolean met = dCollide(ray, geoms.get(geom), 1, contacts.geometry(), ContactMemory.SIZE) > 0;
    if (met) {
      contacts.read(0, contact);
    }
    return met;
  }

  // ------------------------------------------------------------------ time

  @Override
  public void step(long number) {
    // The library has one state of random numbers for all worlds of the process, and one class
    // here for each class loader of a component.
    synchronized (Native.class) {
      dRandSetSeed(number);
      if (settings.solver() == PhysicsSettings.Solver.EXACT) {
        dWorldStep(world, settings.step());
      } else {
        dWorldQuickStep(world, settings.step());
      }
      dJointGroupEmpty(contactGroup);
      String complaint = complaint();
      if (complaint != null) {
        throw new SimulationException("ODE: " + complaint);
      }
    }
  }

  @Override
  public void close() {
    dJointGroupDestroy(contactGroup);
    dGeomDestroy(ray);
    dSpaceDestroy(space);
    dWorldDestroy(world);
  }
}
