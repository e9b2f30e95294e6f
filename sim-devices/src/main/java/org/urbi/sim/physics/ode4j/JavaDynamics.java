package org.urbi.sim.physics.ode4j;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.ode4j.math.DQuaternion;
import org.ode4j.math.DQuaternionC;
import org.ode4j.math.DVector3;
import org.ode4j.math.DVector3C;
import org.ode4j.ode.DBallJoint;
import org.ode4j.ode.DBody;
import org.ode4j.ode.DContact;
import org.ode4j.ode.DContactBuffer;
import org.ode4j.ode.DContactGeom;
import org.ode4j.ode.DFixedJoint;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DHingeJoint;
import org.ode4j.ode.DJoint;
import org.ode4j.ode.DJointGroup;
import org.ode4j.ode.DMass;
import org.ode4j.ode.DMisc;
import org.ode4j.ode.DPlane;
import org.ode4j.ode.DRay;
import org.ode4j.ode.DSliderJoint;
import org.ode4j.ode.DSpace;
import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeConstants;
import org.ode4j.ode.OdeHelper;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.Dynamics;
import org.urbi.sim.physics.JointDescription;
import org.urbi.sim.physics.Material;
import org.urbi.sim.physics.PhysicsSettings;

/** A world of ode4j. */
final class JavaDynamics implements Dynamics {
  /** What does not move collides only with what does. */
  private static final long FIXED = 1;

  private static final long MOVING = 2;

  private final PhysicsSettings settings;
  private final DWorld world = OdeHelper.createWorld();
  private final DSpace space = OdeHelper.createHashSpace(null);
  private final DJointGroup contactGroup = OdeHelper.createJointGroup();
  private final DRay ray = OdeHelper.createRay(null, 1);
  private final DContactBuffer contacts = new DContactBuffer(CONTACTS_PER_PAIR);
  private final List<DBody> bodies = new ArrayList<>();
  private final List<DGeom> geoms = new ArrayList<>();
  private final Map<DGeom, Integer> geomNumbers = new IdentityHashMap<>();
  private final List<DJoint> joints = new ArrayList<>();

  JavaDynamics(PhysicsSettings settings) {
    this.settings = settings;
    Vec3 g = settings.gravity();
    world.setGravity(g.x(), g.y(), g.z());
    world.setCFM(PhysicsSettings.SOFTNESS);
    world.setQuickStepNumIterations(settings.iterations());
  }

  // ------------------------------------------------------------------ bodies

  @Override
  public int createBody(double kilograms, double[] i) {
    DBody body = OdeHelper.createBody(world);
    DMass mass = OdeHelper.createMass();
    mass.setParameters(kilograms, 0, 0, 0, i[0], i[1], i[2], i[3], i[4], i[5]);
    body.setMass(mass);
    bodies.add(body);
    return bodies.size() - 1;
  }

  private @Nullable DBody body(int number) {
    return number == WORLD ? null : bodies.get(number);
  }

  @Override
  public void readBody(int number, double[] state) {
    DBody body = bodies.get(number);
    copy(body.getPosition(), state, 0);
    DQuaternionC q = body.getQuaternion();
    for (int i = 0; i < 4; i++) {
      state[3 + i] = q.get(i);
    }
    copy(body.getLinearVel(), state, 7);
    copy(body.getAngularVel(), state, 10);
  }

  private static void copy(DVector3C vector, double[] numbers, int at) {
    numbers[at] = vector.get0();
    numbers[at + 1] = vector.get1();
    numbers[at + 2] = vector.get2();
  }

  @Override
  public void placeBody(int number, Vec3 p, Rotation rotation) {
    bodies.get(number).setPosition(p.x(), p.y(), p.z());
    bodies.get(number).setQuaternion(quaternion(rotation));
  }

  private static DQuaternion quaternion(Rotation r) {
    return new DQuaternion(r.w(), r.x(), r.y(), r.z());
  }

  @Override
  public void moveBody(int number, Vec3 v, Vec3 spin) {
    bodies.get(number).setLinearVel(v.x(), v.y(), v.z());
    bodies.get(number).setAngularVel(spin.x(), spin.y(), spin.z());
  }

  @Override
  public void addForce(int number, Vec3 f, Vec3 p) {
    bodies.get(number).addForceAtPos(f.x(), f.y(), f.z(), p.x(), p.y(), p.z());
  }

  // ------------------------------------------------------------------ shapes

  @Override
  public int createGeom(int body, Shape shape, Pose pose) {
    DGeom geom =
        switch (shape) {
          case Shape.Sphere s -> OdeHelper.createSphere(space, s.radius());
          case Shape.Box b -> OdeHelper.createBox(space, b.x(), b.y(), b.z());
          case Shape.Cylinder c -> OdeHelper.createCylinder(space, c.radius(), c.length());
          case Shape.Capsule c -> OdeHelper.createCapsule(space, c.radius(), c.length());
          case Shape.Plane p -> OdeHelper.createPlane(space, 0, 0, 1, 0);
        };
    geoms.add(geom);
    geomNumbers.put(geom, geoms.size() - 1);
    if (body == WORLD) {
      geom.setCategoryBits(FIXED);
      geom.setCollideBits(MOVING);
      placeGeom(geoms.size() - 1, shape, pose);
    } else {
      geom.setCategoryBits(MOVING);
      geom.setCollideBits(FIXED | MOVING);
      geom.setBody(bodies.get(body));
      Vec3 p = pose.position();
      geom.setOffsetPosition(p.x(), p.y(), p.z());
      geom.setOffsetQuaternion(quaternion(pose.rotation()));
    }
    return geoms.size() - 1;
  }

  @Override
  public void placeGeom(int number, Shape shape, Pose pose) {
    DGeom geom = geoms.get(number);
    Vec3 p = pose.position();
    if (geom instanceof DPlane plane) {
      Vec3 up = pose.rotation().apply(Vec3.Z);
      plane.setParams(up.x(), up.y(), up.z(), up.dot(p));
    } else {
      geom.setPosition(p.x(), p.y(), p.z());
      geom.setQuaternion(quaternion(pose.rotation()));
    }
  }

  // ------------------------------------------------------------------ joints

  @Override
  public int createJoint(JointDescription.Kind kind, int first, int second, Vec3 a, Vec3 axis) {
    DJoint joint =
        switch (kind) {
          case FIXED -> OdeHelper.createFixedJoint(world);
          case HINGE -> OdeHelper.createHingeJoint(world);
          case SLIDER -> OdeHelper.createSliderJoint(world);
          case BALL -> OdeHelper.createBallJoint(world);
        };
    // For ODE, it is the first body that moves with respect to the second.
    joint.attach(body(second), body(first));
    switch (joint) {
      case DFixedJoint fixed -> fixed.setFixed();
      case DHingeJoint hinge -> {
        hinge.setAnchor(a.x(), a.y(), a.z());
        hinge.setAxis(axis.x(), axis.y(), axis.z());
      }
      case DSliderJoint slider -> slider.setAxis(axis.x(), axis.y(), axis.z());
      default -> ((DBallJoint) joint).setAnchor(a.x(), a.y(), a.z());
    }
    joint.setFeedback(OdeHelper.createJointFeedback());
    joints.add(joint);
    return joints.size() - 1;
  }

  @Override
  public void setLimits(int joint, double low, double high) {
    joints.get(joint).setParam(DJoint.PARAM_N.dParamLoStop1, low);
    joints.get(joint).setParam(DJoint.PARAM_N.dParamHiStop1, high);
  }

  @Override
  public void setMotor(int joint, double velocity, double force) {
    joints.get(joint).setParam(DJoint.PARAM_N.dParamVel1, velocity);
    joints.get(joint).setParam(DJoint.PARAM_N.dParamFMax1, force);
  }

  @Override
  public void addJointForce(int joint, double force) {
    if (joints.get(joint) instanceof DHingeJoint hinge) {
      hinge.addTorque(force);
    } else {
      ((DSliderJoint) joints.get(joint)).addForce(force);
    }
  }

  @Override
  public double jointPosition(int joint) {
    return joints.get(joint) instanceof DHingeJoint hinge
        ? hinge.getAngle()
        : ((DSliderJoint) joints.get(joint)).getPosition();
  }

  @Override
  public double jointVelocity(int joint) {
    return joints.get(joint) instanceof DHingeJoint hinge
        ? hinge.getAngleRate()
        : ((DSliderJoint) joints.get(joint)).getPositionRate();
  }

  @Override
  public double jointLoad(int number) {
    DJoint joint = joints.get(number);
    DVector3 axis = new DVector3();
    Vec3 force = vector(joint.getFeedback().f1);
    if (!(joint instanceof DHingeJoint hinge)) {
      ((DSliderJoint) joint).getAxis(axis);
      return force.dot(vector(axis));
    }
    hinge.getAxis(axis);
    DVector3 anchor = new DVector3();
    hinge.getAnchor(anchor);
    Vec3 arm = vector(anchor).minus(vector(joint.getBody(0).getPosition()));
    // The torque is given about the centre of mass; what the force does there is not the joint's.
    return vector(joint.getFeedback().t1).minus(arm.cross(force)).dot(vector(axis));
  }

  private static Vec3 vector(DVector3C v) {
    return new Vec3(v.get0(), v.get1(), v.get2());
  }

  // ------------------------------------------------------------------ collisions

  private int number(DGeom geom) {
    return requireNonNull(geomNumbers.get(geom), "no geom of another world is in this space");
  }

  @Override
  public void findNearPairs(PairConsumer pairs) {
    space.collide(null, (data, first, second) -> pairs.near(number(first), number(second)));
  }

  @Override
  public int collide(int first, int second, double[] numbers) {
    int count =
        OdeHelper.collide(
            geoms.get(first), geoms.get(second), CONTACTS_PER_PAIR, contacts.getGeomBuffer());
    for (int i = 0; i < count; i++) {
      read(contacts.get(i).geom, numbers, i * CONTACT_SIZE);
    }
    return count;
  }

  private static void read(DContactGeom contact, double[] numbers, int at) {
    copy(contact.pos, numbers, at);
    copy(contact.normal, numbers, at + 3);
    numbers[at + 6] = contact.depth;
  }

  @Override
  public void keepContacts(int firstBody, int secondBody, int count, Material material) {
    for (int i = 0; i < count; i++) {
      DContact contact = contacts.get(i);
      DContact.DSurfaceParameters surface = contact.surface;
      surface.mode = OdeConstants.dContactApprox1;
      surface.mu = material.friction();
      if (material.bounce() > 0) {
        surface.mode |= OdeConstants.dContactBounce;
        surface.bounce = material.bounce();
        surface.bounce_vel = Material.SLOWEST_BOUNCE;
      }
      if (material.rolling() > 0) {
        surface.mode |= OdeConstants.dContactRolling;
        surface.rho = material.rolling();
        surface.rho2 = material.rolling();
        surface.rhoN = material.rolling();
      }
      OdeHelper.createContactJoint(world, contactGroup, contact)
          .attach(body(firstBody), body(secondBody));
    }
  }

  @Override
  public void findOnRay(Vec3 from, Vec3 d, double length, PairConsumer pairs) {
    ray.setLength(length);
    ray.set(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
    ray.collide2(
        space,
        null,
        (data, first, second) -> pairs.near(WORLD, number(first == ray ? second : first)));
  }

  @Override
  public boolean meet(int geom, double[] contact) {
    boolean met = OdeHelper.collide(ray, geoms.get(geom), 1, contacts.getGeomBuffer()) > 0;
    if (met) {
      read(contacts.get(0).geom, contact, 0);
    }
    return met;
  }

  // ------------------------------------------------------------------ time

  @Override
  public void step(long number) {
    // The random numbers are those of all worlds of the process.
    synchronized (DMisc.class) {
      DMisc.dRandSetSeed(number);
      if (settings.solver() == PhysicsSettings.Solver.EXACT) {
        world.step(settings.step());
      } else {
        world.quickStep(settings.step());
      }
    }
    contactGroup.empty();
  }

  @Override
  public void close() {
    contactGroup.destroy();
    ray.destroy();
    space.destroy();
    world.destroy();
  }
}
