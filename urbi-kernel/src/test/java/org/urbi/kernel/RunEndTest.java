package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import urbi.UObject;
import urbi.UVar;

/** When a run is over by itself: as soon as nothing can wake it, and no sooner. */
class RunEndTest {
  /** More than the end of a program takes after its last word. */
  private static final int TICKS_TO_REST = 20;

  /** The program, and what it has been told. */
  private static final class Program implements Client {
    private final StringBuffer output = new StringBuffer();
    private final CompletableFuture<Void> ready = new CompletableFuture<>();
    private final CompletableFuture<Void> closed = new CompletableFuture<>();
    private volatile boolean failed;

    @Override
    public void output(String bytes) {
      output.append(bytes);
      if (output.indexOf("ready") >= 0) {
        ready.complete(null);
      }
    }

    @Override
    public void closed() {
      closed.complete(null);
    }

    @Override
    public boolean isProgram() {
      return true;
    }

    @Override
    public void failed() {
      failed = true;
    }

    /** What has been printed, without the time stamps. */
    String text() {
      return output.toString().replaceAll("\\[\\d+(:\\w+)?] ", "[$1] ");
    }
  }

  private final Program program = new Program();

  private Kernel kernel(boolean virtualTime) {
    return Kernel.builder().virtualTime(virtualTime).start();
  }

  private void run(Kernel kernel, String source) {
    Connection connection = kernel.connect(program);
    connection.send(source);
    connection.end();
  }

  private String textOfWholeRun(String source) throws Exception {
    try (Kernel kernel = kernel(true)) {
      run(kernel, source);
      program.closed.get();
      return program.text();
    }
  }

  /** Somebody for whom no kernel keeps running. */
  private static final class Observer implements Client {
    @Override
    public void output(String bytes) {}

    @Override
    public void closed() {}

    @Override
    public boolean isAwaited() {
      return false;
    }
  }

  /**
   * Waits until a program that says "ready" at its end rests, and the kernel has looked whether it
   * is over: it does so in each tick that runs nothing, as one does that only answers a question.
   */
  private boolean isOverAtRest(Kernel kernel) throws InterruptedException, ExecutionException {
    program.ready.get();
    Connection observer = kernel.connect(new Observer());
    Set<Long> ticks = new HashSet<>();
    while (ticks.size() < TICKS_TO_REST) {
      ticks.add(observer.sample(List.of()).get().time());
    }
    observer.close();
    return program.closed.isDone();
  }

  @Test
  void nothingIsLeftToDo() throws Exception {
    assertEquals("[] *** a\n", textOfWholeRun("var x = 1|; at (x > 1) echo(x); echo(\"a\");"));
    assertFalse(program.failed);
  }

  @Test
  void jobsOfNobodyAreAwaited() throws Exception {
    String source = "disown({ sleep(1h); echo(\"late\") })|; { sleep(2h); echo(\"later\") },";
    assertEquals("[] *** late\n[] *** later\n", textOfWholeRun(source));
  }

  @Test
  void aConditionThatWaitsForItsTimeIsAwaited() throws Exception {
    String source = "var x = 1|; at (x > 0 ~ 1h) { x = 2; echo(x) };";
    assertEquals("[] *** 2\n", textOfWholeRun(source));
  }

  @Test
  void lobbiesOfTheProgramDoNotKeepIt() throws Exception {
    assertEquals("[] *** 1\n", textOfWholeRun("var l = Lobby.create()|; l.receive(\"echo(1);\");"));
  }

  @Test
  void errorsAreToldOf() throws Exception {
    textOfWholeRun("echo(1;\necho(2);");
    assertTrue(program.failed);
  }

  @Test
  void exceptionsInTheBackgroundAreToldOf() throws Exception {
    textOfWholeRun("{ sleep(1s); throw 1 },");
    assertTrue(program.failed);
  }

  @Test
  void whatIsCaughtIsNoFailure() throws Exception {
    textOfWholeRun("try { 1 / 0 } catch (var e) {}; t: { t.stop }; echo(1);");
    assertFalse(program.failed);
  }

  /** A component that counts. */
  public static final class Ticker extends UObject {
    private final UVar count = new UVar();

    public Ticker(String name) {
      super(name);
      UBindFunction(this, "init");
    }

    /** Begins to count. */
    public int init() {
      UBindVar(count, "count");
      count.setValue(0);
      USetTimer(100, this, "tick");
      return 0;
    }

    /** Counts. */
    public int tick() {
      count.setValue(count.intValue() + 1);
      return 0;
    }
  }

  @Test
  void aTimerOfAComponentKeepsIt() throws Exception {
    try (Kernel kernel = kernel(true)) {
      kernel.start(Ticker.class);
      run(kernel, "var t = Ticker.new()|; at (t.count > 5) { echo(\"six\"); shutdown(7) };");
      assertEquals(7, kernel.awaitTermination());
      assertEquals("[] *** six\n", program.text());
    }
  }

  /** A component with a variable, which some thread may set. */
  public static final class Sensor extends UObject {
    static volatile Sensor last;
    final UVar value = new UVar();

    public Sensor(String name) {
      super(name);
      UBindFunction(this, "init");
    }

    /** Is there. */
    public int init() {
      UBindVar(value, "value");
      value.setValue(0);
      last = this;
      return 0;
    }
  }

  @Test
  void whoListensToAComponentKeepsIt() throws Exception {
    try (Kernel kernel = kernel(false)) {
      kernel.start(Sensor.class);
      run(kernel, "var s = Sensor.new()|; at (s.value > 5) shutdown(3); echo(\"ready\");");
      assertFalse(isOverAtRest(kernel));
      Sensor.last.value.setValue(6);
      assertEquals(3, kernel.awaitTermination());
    }
  }

  @Test
  void aComponentToWhichNobodyListensDoesNot() throws Exception {
    try (Kernel kernel = kernel(false)) {
      kernel.start(Sensor.class);
      run(kernel, "var s = Sensor.new()|; echo(\"ready\");");
      assertTrue(isOverAtRest(kernel));
    }
  }

  @Test
  void aConnectionKeepsIt() throws Exception {
    try (Kernel kernel = kernel(false)) {
      Client other =
          new Client() {
            @Override
            public void output(String bytes) {}

            @Override
            public void closed() {}
          };
      Connection connection = kernel.connect(other);
      run(kernel, "echo(\"ready\");");
      assertFalse(isOverAtRest(kernel));
      connection.close();
      program.closed.get();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "var s = Server.new()|; s.listen(\"127.0.0.1\", \"0\")|; at (s.connection?) echo(1);",
        "var p = Process.new(\"sleep\", [\"9\"])|; p.run()| at (p.status.exited) echo(1);",
        "var d = Directory.new(\".\")|; at (d.fileCreated?(var name)) echo(name);",
      })
  void whatComesFromOutsideKeepsIt(String source) throws Exception {
    try (Kernel kernel = kernel(false)) {
      run(kernel, source + " echo(\"ready\");");
      assertFalse(isOverAtRest(kernel), program::text);
    }
  }
}
