package org.urbi.bench.jmh;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.urbi.lang.input.Item;
import org.urbi.lang.input.StatementReader;

/** From text to tree, and from text to answer. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class TextBenchmark {
  private static final int PARAGRAPHS = 10;

  /** Ten lines of what programs are made of. */
  private static final String PARAGRAPH =
      """
      class Motor {
        var speed = 0;
        function init(s) { speed = s | maximum = 100 };
        function run(n) { if (n < 2) n else run(n - 1) + speed * 2 / 3 };
      };
      var motor = Motor.new(10);
      at (motor.speed > 50 ~ 100ms) echo("too fast: " + motor.speed);
      every (20ms) { motor.speed += 1 | motor.run(3) },
      for| (var i : [1, 2, 3]) { motor.speed = i & robot.head.val = i };
      try { motor.go("left", ["speed" => 3]) } catch (var e) { cerr << e };
      """;

  private static final String PROGRAM = PARAGRAPH.repeat(PARAGRAPHS);

  private Session session;

  @Setup(Level.Trial)
  public void open() {
    session = new Session();
    int statements = parseHundredLines();
    if (statements != 6 * PARAGRAPHS) {
      throw new IllegalStateException("the program has " + statements + " statements");
    }
  }

  @TearDown(Level.Trial)
  public void close() {
    session.close();
  }

  /** As the kernel reads: statement by statement. */
  @Benchmark
  public int parseHundredLines() {
    StatementReader reader = new StatementReader(null);
    reader.feed(PROGRAM);
    int statements = 0;
    for (var item = reader.next(); item != null; item = reader.next()) {
      if (item instanceof Item.Invalid errors) {
        throw new IllegalStateException(errors.errors().getFirst().message());
      }
      statements++;
    }
    return statements;
  }

  /** One statement through a connection: two changes of thread, parsing, executing, printing. */
  @Benchmark
  public String roundTrip() {
    return session.evaluate("1 + 2;\n");
  }
}
