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
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** What one turn of a loop costs, by what it does; {@code EMPTY} is the loop itself. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class CodeBenchmark {
  private static final int TURNS = 20_000;
  private static final String REQUEST = "turns(" + TURNS + ");\n";

  /** What a turn does. */
  public enum Turn {
    EMPTY("", "i"),
    ARITHMETIC("", "x = (i * 3 + 1) / 7 - i % 5"),
    SEND_MONOMORPHIC("class A { function same(n) { n } }|; var a = A.new|;", "x = a.same(i)"),
    SEND_MEGAMORPHIC(
        """
        var many = []|;
        for| (var k : 16) {
          var o = Object.new;
          o.setSlot("own" + k, k);
          o.setSlot("same", function (n) { n });
          many << o
        }|;
        """,
        "x = many[i % 16].same(i)"),
    SLOT_READ("var o = Object.new|; var o.x = 1|;", "x = o.x"),
    SLOT_WRITE("var o = Object.new|; var o.x = 1|;", "o.x = i"),
    LIST_APPEND("var l = []|;", "{ if (i == 0) l.clear | l << i }"),
    DICTIONARY_UPDATE("var d = [\"one\" => 1, \"two\" => 2]|;", "d[\"one\"] = i"),
    STRING_BUILDING("var s = \"\"|;", "{ if (i % 100 == 0) s = \"\" | s += \"x\" }"),
    EVENT_WITHOUT_HANDLER("var e = Event.new|;", "e!"),
    EVENT_SYNC_HANDLER("var e = Event.new|; at sync (e?) { x = 1 }|;", "e!");

    private final String before;
    private final String body;

    Turn(String before, String body) {
      this.before = "var x = 0|;\n" + before + "\n";
      this.body = body;
    }
  }

  // JMH sets it before the setup.
  @SuppressWarnings("NullAway.Init")
  @Param
  public Turn turn;

  private Session session;

  @Setup(Level.Trial)
  public void open() {
    session = new Session();
    session.defineTurns(turn.before, turn.body);
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
}
