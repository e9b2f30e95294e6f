package org.urbi.bench.jmh;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** What jobs and events cost, the turn of the loop around them included. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class JobBenchmark {
  private static final int MANY = 10_000;

  private Session session;

  @Setup(Level.Trial)
  public void open() {
    session = new Session();
    session.evaluate(
        """
        function alone(n) { var i = 0; while (i < n) { i += 1 }; i }|;
        function switches(n) {
          for& (var j : 100) { var i = 0; while (i < n) { i += 1 } };
          n
        }|;
        function spawns(n) { var done = 0; for& (var i : n) { done += 1 }; done }|;
        var ring = Event.new|;
        var heard = 0|;
        at (ring?) { heard += 1 }|;
        function emits(n) {
          heard = 0;
          var i = 0;
          while (i < n) { ring!; i += 1 };
          while (heard < n) {};
          heard
        }|;
        var watched = Object.new|;
        var watched.x = 0|;
        var seen = 0|;
        at (watched.x % 2 == 1) { seen += 1 }|;
        function changes(n) {
          seen = 0;
          watched.x = 0;
          var i = 0;
          while (i < n) { watched.x = watched.x + 1; i += 1 };
          seen
        }|;
        "ready";
        """);
  }

  @TearDown(Level.Trial)
  public void close() {
    session.close();
  }

  /** {@code ;} with nobody else to run. */
  @Benchmark
  @OperationsPerInvocation(MANY)
  public String semicolonAlone() {
    return session.evaluate("alone(10000);\n");
  }

  @Benchmark
  @OperationsPerInvocation(MANY)
  public String switchAmongHundred() {
    return session.evaluate("switches(100);\n");
  }

  /** A job is started, runs and ends. */
  @Benchmark
  @OperationsPerInvocation(MANY)
  public String spawn() {
    return session.evaluate("spawns(10000);\n");
  }

  @Benchmark
  @OperationsPerInvocation(MANY)
  public String eventOneHandler() {
    return session.evaluate("emits(10000);\n");
  }

  @Benchmark
  @OperationsPerInvocation(MANY)
  public String changeSeenByAt() {
    return session.evaluate("changes(10000);\n");
  }
}
