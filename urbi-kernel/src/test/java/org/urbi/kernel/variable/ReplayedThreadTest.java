package org.urbi.kernel.variable;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.ReplayedRun;
import org.urbi.kernel.TestTimeout;
import urbi.LockMode;
import urbi.UContext;
import urbi.UObject;
import urbi.UProperty;
import urbi.UVar;

/** A run whose component has a thread of its own is replayed without what that thread does. */
class ReplayedThreadTest {
  /** How the threads of all sensors have ended. */
  private static final BlockingQueue<String> ENDS = new LinkedBlockingQueue<>();

  /** Senses on a thread of its own, which nobody can foresee. */
  public static final class Sensor extends UObject {
    private final UVar value = new UVar();
    private final UVar owned = new UVar();
    private volatile String state = "closed";

    public Sensor(String name) {
      super(name);
      UBindVar(value, "value");
      UBindVar(owned, "owned");
      UOwned(owned);
      UBindFunctions("begin", "later", "open", "state");
      UBindThreadedFunction("measure", LockMode.LOCK_NONE);
      UBindThreadedFunction("measureLater", LockMode.LOCK_NONE);
    }

    public List<Double> measure() {
      return List.of(Math.random());
    }

    public CompletableFuture<Double> measureLater() {
      return CompletableFuture.supplyAsync(Math::random);
    }

    public CompletableFuture<UVar> later() {
      return CompletableFuture.supplyAsync(() -> value);
    }

    /** Takes longer than a replay does. */
    public CompletableFuture<Void> open() {
      return CompletableFuture.runAsync(
          () -> state = "open", CompletableFuture.delayedExecutor(100, TimeUnit.MILLISECONDS));
    }

    public String state() {
      return state;
    }

    public void begin() {
      UContext context = UContext.current();
      Thread.ofPlatform().daemon().start(() -> sense(context));
    }

    private void sense(UContext context) {
      UContext.enter(context);
      try {
        for (int i = 0; i < 3; i++) {
          value.setValue(i + Math.random());
          value.setValue(value.doubleValue() * 2);
        }
        owned.setValue(value.doubleValue());
        value.setProp(UProperty.PROP_RANGEMAX, 100);
        value.setValue(1000 + value.getProp(UProperty.PROP_RANGEMAX).doubleValue());
        UVar other = new UVar("Sensor.other");
        other.setValue("text");
        value.unnotify();
        other.setValue("done");
        ENDS.add("done");
      } catch (IllegalStateException e) {
        ENDS.add(e.getMessage());
      }
    }
  }

  @TempDir Path folder;

  private static String nextEnd() throws InterruptedException {
    return ENDS.poll(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
  }

  @Test
  void whatAThreadHasWrittenIsWrittenAgain() throws Exception {
    StringBuffer shown = new StringBuffer();
    Path run = folder.resolve("run");
    try (Kernel kernel =
        Kernel.builder().virtualTime(true).output(shown::append).record(run).start()) {
      kernel.start(Sensor.class);
      CompletableFuture<Object> done =
          kernel.evalAsync(
              "at (Sensor.value->changed?) echo(\"value: \" + Sensor.value);"
                  + " at (Sensor.owned->changed?) echo(\"owned: \" + Sensor.owned);"
                  + " UVar.new(Sensor, \"other\")|; Sensor.other = 0|;"
                  + " at (Sensor.other->changed?) echo(\"other: \" + Sensor.other);"
                  + " Sensor.begin(); waituntil (Sensor.other == \"done\"); echo(\"done\")");
      assertEquals("done", nextEnd());
      done.get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
    }
    for (String part : new String[] {"value: 0.", "value: 100\n", "other: text", "done\n"}) {
      assertTrue(shown.toString().contains(part), shown.toString());
    }

    assertEquals(shown.toString(), ReplayedRun.replayed(run));
    assertEquals("in a replay, threads of components have no say", nextEnd());
  }

  @Test
  void whatAThreadHasFoundOutIsFoundOutAgain() {
    String shown =
        shownAgain(
            "Sensor.value = 7|; echo(Sensor.measure()); echo(Sensor.measureLater());"
                + " echo(Sensor.later().val)");
    assertTrue(shown.matches("(?s).*\\[0\\.\\d+].*0\\.\\d+\n.*\\*\\*\\* 7\n"), shown);
  }

  @Test
  void whatAComponentDoesBeforeItAnswersIsDoneForTheNextCall() {
    String shown = shownAgain("Sensor.open; echo(Sensor.state)");
    assertTrue(shown.endsWith("*** open\n"), shown);
  }

  /** What a program with the sensor shows, which its replay shows, too. */
  private String shownAgain(String program) {
    Path run = folder.resolve("run");
    String shown =
        ReplayedRun.recorded(
            run,
            kernel -> {
              kernel.start(Sensor.class);
              kernel.eval(program);
            });
    assertEquals(shown, ReplayedRun.replayed(run));
    return shown;
  }
}
