package org.urbi.sim.physics.ode;

import static java.lang.foreign.ValueLayout.JAVA_DOUBLE;
import static java.lang.foreign.ValueLayout.JAVA_INT;
import static java.lang.foreign.ValueLayout.JAVA_LONG;

import com.sun.jna.Pointer;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemorySegment;
import java.lang.invoke.MethodHandle;

/**
 * The functions of libode that a step calls hundreds of times: by the JDK's own foreign calls,
 * which take a tenth of JNA's time. The library is the one that JNA has found, and a pointer is a
 * {@code long} here, too.
 */
final class StepCalls {
  private static final MethodHandle COLLIDE =
      function(
          "dCollide",
          FunctionDescriptor.of(JAVA_INT, JAVA_LONG, JAVA_LONG, JAVA_INT, JAVA_LONG, JAVA_INT));
  private static final MethodHandle CREATE_CONTACT =
      function(
          "dJointCreateContact", FunctionDescriptor.of(JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));
  private static final MethodHandle ATTACH =
      function("dJointAttach", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG, JAVA_LONG));
  private static final MethodHandle HINGE_ANGLE =
      function("dJointGetHingeAngle", FunctionDescriptor.of(JAVA_DOUBLE, JAVA_LONG));
  private static final MethodHandle COLLIDE_SPACE =
      function("dSpaceCollide", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG, JAVA_LONG));
  private static final MethodHandle COLLIDE_SPACES =
      function(
          "dSpaceCollide2", FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_LONG));

  private StepCalls() {}

  /**
   * Has all of them found.
   *
   * @throws LinkageError if the library lacks one
   */
  static void link() {
    // The class has been initialized when this is called.
  }

  @SuppressWarnings("restricted") // The types are those of ODE's headers.
  private static MethodHandle function(String name, FunctionDescriptor type) {
    long address = Pointer.nativeValue(OdeLibrary.function(name));
    return Linker.nativeLinker().downcallHandle(MemorySegment.ofAddress(address), type);
  }

  static int dCollide(long first, long second, int flags, long contacts, int skip) {
    try {
      return (int) COLLIDE.invokeExact(first, second, flags, contacts, skip);
    } catch (Throwable e) {
      throw unexpected(e);
    }
  }

  static long dJointCreateContact(long world, long group, long contact) {
    try {
      return (long) CREATE_CONTACT.invokeExact(world, group, contact);
    } catch (Throwable e) {
      throw unexpected(e);
    }
  }

  static void dJointAttach(long joint, long first, long second) {
    try {
      ATTACH.invokeExact(joint, first, second);
    } catch (Throwable e) {
      throw unexpected(e);
    }
  }

  static double dJointGetHingeAngle(long joint) {
    try {
      return (double) HINGE_ANGLE.invokeExact(joint);
    } catch (Throwable e) {
      throw unexpected(e);
    }
  }

  static void dSpaceCollide(long space, long data, long callback) {
    try {
      COLLIDE_SPACE.invokeExact(space, data, callback);
    } catch (Throwable e) {
      throw unexpected(e);
    }
  }

  static void dSpaceCollide2(long first, long second, long data, long callback) {
    try {
      COLLIDE_SPACES.invokeExact(first, second, data, callback);
    } catch (Throwable e) {
      throw unexpected(e);
    }
  }

  /** C throws nothing: this is of the JVM itself, such as an overflow of its stack. */
  private static Error unexpected(Throwable e) {
    if (e instanceof Error error) {
      return error;
    }
    throw new IllegalStateException(e);
  }
}
