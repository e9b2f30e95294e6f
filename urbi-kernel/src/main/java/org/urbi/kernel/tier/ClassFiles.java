package org.urbi.kernel.tier;

import java.lang.classfile.Attributes;
import java.lang.classfile.ClassFile;
import java.lang.classfile.ClassHierarchyResolver;
import java.lang.classfile.CodeBuilder;
import java.lang.classfile.MethodModel;
import java.lang.classfile.attribute.CodeAttribute;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.lang.invoke.MethodHandles;
import org.urbi.kernel.tier.Tier.Emission;

/**
 * Makes the class files of emitted code. They are of a version whose methods need no maps of what
 * is on the stack where jumps come together: to compute these takes a quarter of the time of
 * emitting, and the Java machine itself finds out in a fraction of that.
 */
final class ClassFiles {
  /** The Java machine never compiles a method with more bytes than this. */
  static final int MOST_BYTES = 8000;

  /** The name of the method that executes a loop, or calls a function. */
  static final String RUN = "run";

  private static final MethodTypeDesc CONSTRUCTOR =
      MethodTypeDesc.of(ConstantDescs.CD_void, Names.MISSES);

  private final ClassFile plain = ClassFile.of(ClassFile.StackMapsOption.DROP_STACK_MAPS);

  /** Asks loaded classes what they extend; otherwise their files would be read. */
  private final ClassFile mapped =
      ClassFile.of(
          ClassFile.ClassHierarchyResolverOption.of(
              ClassHierarchyResolver.ofClassLoading(MethodHandles.lookup()).cached()));

  /**
   * A class file.
   *
   * @param unit whose constants it has
   */
  record Made(byte[] bytes, Unit unit) {}

  /** Makes one. */
  Made make(Unit unit, Emission emission) {
    byte[] bytes = build(plain, ClassFile.JAVA_5_VERSION, unit, emission);
    if (unit.slots().get() <= slots(unit, bytes)) {
      return new Made(bytes, unit);
    }
    // Code that can never be reached has taken slots, for which the JDK makes room only where it
    // makes maps, too.
    Unit again = unit.again();
    return new Made(build(mapped, ClassFile.latestMajorVersion(), again, emission), again);
  }

  private static byte[] build(ClassFile files, int version, Unit unit, Emission emission) {
    return files.build(
        unit.owner(),
        type -> {
          type.withVersion(version, 0);
          type.withSuperclass(Names.COMPILED_CODE).withFlags(ClassFile.ACC_FINAL);
          type.withMethodBody(ConstantDescs.INIT_NAME, CONSTRUCTOR, 0, ClassFiles::construct);
          emission.emit(type, unit);
          unit.constants().declare(type);
        });
  }

  /**
   * For how many slots of the emitted code the Java machine makes room.
   *
   * @throws TooLong if it would never compile a method
   */
  private int slots(Unit unit, byte[] bytes) {
    String emitted = unit.isLoop() ? RUN : EmitFunction.BODY;
    int slots = 0;
    for (MethodModel method : plain.parse(bytes).methods()) {
      CodeAttribute code = method.findAttribute(Attributes.code()).orElseThrow();
      if (code.codeLength() > MOST_BYTES) {
        throw new TooLong();
      }
      if (method.methodName().equalsString(emitted)) {
        slots = code.maxLocals();
      }
    }
    return slots;
  }

  private static void construct(CodeBuilder code) {
    code.aload(0)
        .aload(1)
        .invokespecial(Names.COMPILED_CODE, ConstantDescs.INIT_NAME, CONSTRUCTOR)
        .return_();
  }
}
