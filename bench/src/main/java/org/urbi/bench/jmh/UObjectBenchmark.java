package org.urbi.bench.jmh;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * What a call of a plugged UObject costs, and an access to its variable, beside a call of an
 * urbiscript function ({@code URBISCRIPT}), the loop itself ({@code EMPTY}) and the bare method
 * handle.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class UObjectBenchmark {
  private static final int TURNS = 20_000;
  private static final String REQUEST = "turns(" + TURNS + ");\n";

  /** What a turn does. */
  public enum Turn {
    EMPTY("i"),
    URBISCRIPT("x = a.same(i)"),
    BOUND("x = MeasuredObject.same(i)"),
    BOUND_TEXT("x = MeasuredObject.text(\"text\")"),
    BOUND_LIST("x = MeasuredObject.sum(l)"),
    BOUND_READING("x = MeasuredObject.add(i)"),
    READ("x = MeasuredObject.val"),
    WRITE("MeasuredObject.val = i"),
    WRITE_NOTIFYING("MeasuredObject.watched = i");

    private final String body;

    Turn(String body) {
      this.body = body;
    }
  }

  // JMH sets it before the setup.
  @SuppressWarnings("NullAway.Init")
  @Param
  public Turn turn;

  private Session session;
  private MethodHandle handle;
  private double argument;

  @Setup(Level.Trial)
  public void open() throws ReflectiveOperationException {
    session = new Session();
    session.start(MeasuredObject.class);
    session.defineTurns(
        "var x = 0|; var l = [1, 2, 3]|; class A { function same(n) { n } }|; var a = A.new|;",
        turn.body);
    handle =
        MethodHandles.lookup()
            .findStatic(
                UObjectBenchmark.class, "twice", MethodType.methodType(double.class, double.class));
  }

  static double twice(double n) {
    return n + n;
  }

  @TearDown(Level.Trial)
  public void close() {
    session.close();
  }

  @Benchmark
  @OperationsPerInvocation(TURNS)
  public String turn() {
    return session.evaluate(REQUEST);
  }

  /** A method handle that is no constant, as those of bound functions are. */
  @Benchmark
  public double bareHandle() throws Throwable {
    argument = (double) handle.invokeExact(argument);
    return argument;
  }
}
