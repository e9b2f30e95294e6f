package org.urbi.sim.physics.ode;

import static java.util.Objects.requireNonNull;

import com.sun.jna.Callback;
import com.sun.jna.Native;
import com.sun.jna.NativeLibrary;
import com.sun.jna.Pointer;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;

/**
 * The functions of libode that are needed, and nothing else: their names and types are those of its
 * headers, a pointer is a {@code long}. The library has to compute in double precision.
 */
final class OdeLibrary {
  /** Names a library instead of those below. */
  private static final String PROPERTY = "urbi.libode";

  private static final List<String> NAMES = List.of("libode.so.8", "ode", "libode.dylib");

  /** {@code dParamLoStop} and its neighbours. */
  static final int PARAM_LO_STOP = 0;

  static final int PARAM_HI_STOP = 1;
  static final int PARAM_VEL = 2;
  static final int PARAM_FMAX = 5;

  private static final int ALLOCATE_ALL = -1;

  /** Of {@code dMessageFunction}; the last is a {@code va_list}. */
  interface MessageCallback extends Callback {
    void message(int number, String format, Pointer arguments);
  }

  private static final @Nullable SimulationException FAILURE;

  private static final MessageCallback ERRORS = (number, format, arguments) -> note(format);

  /**
   * Messages are of the solver, about contacts that say the same thing twice: it goes on, and ode4j
   * is silent about them.
   */
  private static final MessageCallback MESSAGES = (number, format, arguments) -> {};

  private static @Nullable NativeLibrary library;
  private static @Nullable String noted;

  static {
    SimulationException failure = null;
    try {
      library = find();
      Native.register(OdeLibrary.class, library);
      StepCalls.link();
      requireDoublePrecision(dGetConfiguration());
      dInitODE2(0);
      dSetMessageHandler(MESSAGES);
      dSetErrorHandler(ERRORS);
      dSetDebugHandler(ERRORS);
    } catch (SimulationException e) {
      failure = e;
    } catch (LinkageError e) {
      failure = new SimulationException("libode does not fit: " + e.getMessage(), e);
    }
    FAILURE = failure;
  }

  private OdeLibrary() {}

  private static NativeLibrary find() {
    if (Native.POINTER_SIZE != Long.BYTES) {
      throw new SimulationException("libode: only used on 64-bit machines");
    }
    String named = System.getProperty(PROPERTY);
    List<String> names = named == null ? NAMES : List.of(named);
    for (String name : names) {
      try {
        return NativeLibrary.getInstance(name);
      } catch (UnsatisfiedLinkError e) {
        // The next name may fit; the message below tells what was looked for.
      }
    }
    throw new SimulationException(
        "libode not found (looked for " + String.join(", ", names) + "; Debian: libode8)");
  }

  /** Refuses what computes in single precision: contacts and states would have other layouts. */
  static void requireDoublePrecision(String configuration) {
    if (!List.of(configuration.split(" ")).contains("ODE_double_precision")) {
      throw new SimulationException("libode: not of double precision: " + configuration);
    }
  }

  /**
   * Has the library ready for this thread.
   *
   * @throws SimulationException if there is none that can be used
   */
  static void require() {
    if (FAILURE != null) {
      throw new SimulationException(FAILURE.getMessage(), FAILURE);
    }
    dAllocateODEDataForThread(ALLOCATE_ALL);
  }

  /**
   * Where a function of the library is, for {@link StepCalls}.
   *
   * @throws UnsatisfiedLinkError if it is not there
   */
  static Pointer function(String name) {
    return requireNonNull(library, "asked for once there is one").getFunction(name);
  }

  private static synchronized void note(String format) {
    if (noted == null) {
      noted = format;
    }
  }

  /** What the library has complained of since the last time, or null. */
  static synchronized @Nullable String complaint() {
    String complaint = noted;
    noted = null;
    return complaint;
  }

  static native String dGetConfiguration();

  static native int dInitODE2(int flags);

  static native int dAllocateODEDataForThread(int flags);

  static native void dSetMessageHandler(MessageCallback handler);

  static native void dSetErrorHandler(MessageCallback handler);

  static native void dSetDebugHandler(MessageCallback handler);

  static native void dRandSetSeed(long seed);

  static native long dWorldCreate();

  static native void dWorldDestroy(long world);

  static native void dWorldSetGravity(long world, double x, double y, double z);

  static native void dWorldSetCFM(long world, double softness);

  static native void dWorldSetQuickStepNumIterations(long world, int count);

  static native int dWorldStep(long world, double step);

  static native int dWorldQuickStep(long world, double step);

  static native long dBodyCreate(long world);

  static native void dBodySetMass(long body, Pointer mass);

  static native void dMassSetParameters(
      Pointer mass,
      double m,
      double centreX,
      double centreY,
      double centreZ,
      double i11,
      double i22,
      double i33,
      double i12,
      double i13,
      double i23);

  static native void dBodySetPosition(long body, double x, double y, double z);

  static native void dBodySetQuaternion(long body, double[] quaternion);

  static native void dBodySetLinearVel(long body, double x, double y, double z);

  static native void dBodySetAngularVel(long body, double x, double y, double z);

  static native Pointer dBodyGetPosition(long body);

  static native Pointer dBodyGetQuaternion(long body);

  static native Pointer dBodyGetLinearVel(long body);

  static native Pointer dBodyGetAngularVel(long body);

  static native void dBodyAddForceAtPos(
      long body, double fx, double fy, double fz, double x, double y, double z);

  static native long dSweepAndPruneSpaceCreate(long space, int axes);

  static native void dSpaceDestroy(long space);

  static native long dCreateSphere(long space, double radius);

  static native long dCreateBox(long space, double x, double y, double z);

  static native long dCreateCylinder(long space, double radius, double length);

  static native long dCreateCapsule(long space, double radius, double length);

  static native long dCreatePlane(long space, double a, double b, double c, double d);

  static native void dGeomPlaneSetParams(long plane, double a, double b, double c, double d);

  static native long dCreateRay(long space, double length);

  static native void dGeomRaySetLength(long ray, double length);

  static native void dGeomRaySet(
      long ray, double x, double y, double z, double dx, double dy, double dz);

  static native void dGeomDestroy(long geom);

  static native void dGeomSetBody(long geom, long body);

  static native void dGeomSetPosition(long geom, double x, double y, double z);

  static native void dGeomSetQuaternion(long geom, double[] quaternion);

  static native void dGeomSetOffsetPosition(long geom, double x, double y, double z);

  static native void dGeomSetOffsetQuaternion(long geom, double[] quaternion);

  static native void dGeomSetCategoryBits(long geom, long bits);

  static native void dGeomSetCollideBits(long geom, long bits);

  static native long dJointGroupCreate(int size);

  static native void dJointGroupDestroy(long group);

  static native void dJointGroupEmpty(long group);

  static native long dJointCreateFixed(long world, long group);

  static native long dJointCreateHinge(long world, long group);

  static native long dJointCreateSlider(long world, long group);

  static native long dJointCreateBall(long world, long group);

  static native void dJointSetFeedback(long joint, Pointer feedback);

  static native void dJointSetFixed(long joint);

  static native void dJointSetBallAnchor(long joint, double x, double y, double z);

  static native void dJointSetHingeAnchor(long joint, double x, double y, double z);

  static native void dJointSetHingeAxis(long joint, double x, double y, double z);

  static native void dJointGetHingeAnchor(long joint, double[] anchor);

  static native void dJointGetHingeAxis(long joint, double[] axis);

  static native void dJointSetHingeParam(long joint, int parameter, double value);

  static native double dJointGetHingeAngleRate(long joint);

  static native void dJointAddHingeTorque(long joint, double torque);

  static native void dJointSetSliderAxis(long joint, double x, double y, double z);

  static native void dJointGetSliderAxis(long joint, double[] axis);

  static native void dJointSetSliderParam(long joint, int parameter, double value);

  static native double dJointGetSliderPosition(long joint);

  static native double dJointGetSliderPositionRate(long joint);

  static native void dJointAddSliderForce(long joint, double force);
}
