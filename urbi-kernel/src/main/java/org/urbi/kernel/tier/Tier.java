package org.urbi.kernel.tier;

import java.lang.classfile.ClassBuilder;
import java.lang.classfile.ClassFile;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.node.CodeCompiler;
import org.urbi.kernel.node.CompiledCode;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.node.Misses;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.TurnCount;
import org.urbi.kernel.object.World;

/** Compiles the hot code of one kernel, on the kernel thread, and counts what it does. */
public final class Tier implements CodeCompiler {
  private static final String FUNCTION = "Code";
  private static final String LOOP = "Loop";

  /** What the log calls this part of the kernel. */
  private static final String COMPILER = "the compiler of hot code";

  /**
   * How many turns of a loop count as much as a call. A loop around a hot one is compiled with that
   * one inside, so it must be hot itself.
   */
  private static final int TURNS_PER_CALL = 10;

  /** More variables than most functions have; all of them are written around other code. */
  private static final int MOST_LOCALS = 60;

  /** How many bytes of classes may be in use at once. */
  private static final long MOST_IN_USE = 8L << 20;

  static final MethodTypeDesc RUN =
      MethodTypeDesc.of(
          Names.OBJECT,
          Names.FRAME,
          ConstantDescs.CD_double,
          ConstantDescs.CD_double,
          Names.OBJECTS);

  private static final MethodType NEW = MethodType.methodType(void.class, Misses.class);

  private final World world;
  private final int threshold;
  private final @Nullable Doubt doubt;
  private final KernelLog log;
  private final ClassesInUse inUse = new ClassesInUse(MOST_IN_USE);

  private final ClassFiles files = new ClassFiles();

  /** Whether the Java machine has failed to give what compiling needs. */
  private boolean broken;

  private int functions;
  private int loops;
  private int counting;
  private int refused;
  private long bytes;

  /**
   * @param threshold after how many calls a function is compiled, and after ten times as many turns
   *     a loop; with 1 both at once
   * @param missEvery every how many times compiled code distrusts a number, and a version is
   *     forgotten that has just been made, which must make no difference but for the time; 0 for
   *     never
   * @param log is told of code that could not be compiled because of a defect here
   */
  public Tier(World world, int threshold, int missEvery, KernelLog log) {
    this.world = world;
    this.threshold = threshold;
    this.doubt = missEvery == 0 ? null : new Doubt(missEvery);
    this.log = log;
  }

  @Override
  public int threshold() {
    return threshold;
  }

  @Override
  public long turns() {
    return 1 + TURNS_PER_CALL * (threshold - 1L);
  }

  @Override
  public Statistics statistics() {
    return new Statistics(functions, loops, counting, refused, bytes);
  }

  @Override
  public @Nullable CompiledCode function(
      Function.Body function, Node code, Frame frame, boolean last) {
    CompiledCode compiled =
        attempt(() -> {
          Survey survey = Survey.of(code);
          survey.addAround(Survey.of(function));
          return survey.isWorthwhile()
              ? compile(
                  new Unit(
                      name(FUNCTION),
                      world.values(),
                      doubt,
                      misses(last),
                      survey,
                      frame,
                      function,
                      function.locals(),
                      false,
                      true),
                  new EmitFunction(code))
              : null;
        });
    if (compiled != null) {
      functions++;
    }
    return compiled;
  }

  @Override
  public @Nullable CompiledCode loop(Node loop, Frame frame, boolean last) {
    CompiledCode compiled =
        attempt(() -> {
          TurnCount turns = Emitter.turns(loop);
          return turns == null ? null : loop(loop, turns, frame, last);
        });
    if (compiled != null) {
      loops++;
    }
    return compiled;
  }

  private @Nullable CompiledCode loop(Node loop, TurnCount turns, Frame frame, boolean last) {
    Survey survey = Survey.of(loop);
    Function function = frame.function();
    if (function != null) {
      survey.addAround(Survey.of(function.body()));
    } else if (CompiledCode.isExposed(frame)) {
      survey.addAround(null);
    }
    return compile(
        new Unit(
            name(LOOP),
            world.values(),
            doubt,
            misses(last),
            survey,
            frame,
            null,
            CompiledCode.variables(frame),
            !turns.isAlone() || survey.mayJump(),
            true),
        (type, unit) ->
            type.withMethodBody(
                ClassFiles.RUN,
                RUN,
                ClassFile.ACC_PUBLIC,
                code -> Emitter.ofLoop(code, unit).loops().unit(loop)));
  }

  /** Counts the misses of a new version, unless it is the last one; a test has some forgotten. */
  private Misses misses(boolean last) {
    return !last && doubt != null && doubt.strikes() ? Misses.over() : new Misses(!last);
  }

  /**
   * Compiles something, if that is possible. Otherwise the interpreter does it as well: where the
   * code is long, the stack is nearly exhausted, or a class cannot be loaded because the process
   * has no file descriptors left. Such a class is missing from then on.
   */
  @Nullable CompiledCode attempt(Supplier<@Nullable CompiledCode> work) {
    CompiledCode compiled = null;
    if (!broken) {
      try {
        compiled = work.get();
      } catch (VerifyError | IllegalArgumentException e) {
        log.write("urbi: code is not compiled: " + e);
        FailureLog.internal(COMPILER, e);
      } catch (LinkageError e) {
        broken = true;
        log.write("urbi: code is not compiled any more: " + e);
        FailureLog.internal(COMPILER, e);
      } catch (StackOverflowError | TooLong e) {
        // It is refused.
      }
    }
    if (compiled == null) {
      refused++;
    }
    return compiled;
  }

  /** What is emitted. */
  interface Emission {
    void emit(ClassBuilder type, Unit unit);
  }

  private static ClassDesc name(String simple) {
    return ClassDesc.of(Tier.class.getPackageName(), simple);
  }

  private @Nullable CompiledCode compile(Unit unit, Emission emission) {
    if (unit.locals() > MOST_LOCALS || !inUse.hasRoom()) {
      return null;
    }
    try {
      return emit(unit, emission);
    } catch (TooLong e) {
      return emit(unit.withoutCopies(), emission);
    }
  }

  private CompiledCode emit(Unit unit, Emission emission) {
    ClassFiles.Made made = files.make(unit, emission);
    CompiledCode compiled = instance(made.bytes(), made.unit());
    bytes += made.bytes().length;
    counting += made.unit().counting().get();
    inUse.add(compiled, made.bytes().length);
    return compiled;
  }

  private static CompiledCode instance(byte[] emitted, Unit unit) {
    try {
      MethodHandles.Lookup defined =
          MethodHandles.lookup()
              .defineHiddenClassWithClassData(emitted, unit.constants().values(), true);
      return (CompiledCode)
          defined
              .findConstructor(defined.lookupClass(), NEW)
              .asType(MethodType.methodType(CompiledCode.class, Misses.class))
              .invokeExact(unit.misses());
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }
}
