package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import urbi.UObject;

/** A job that holds the kernel for too long ends, although nobody asks for it. */
class HoldLimitTest {
  /** Somewhere in f, which was called at the third line, or just there. */
  private static final Pattern PLACE =
      Pattern.compile(
          ":error\\] !!! (3\\.1: job shell_|1\\.[0-9-]+: job shell_[^\\n]*\\n.*called from: 3\\.1: f)");

  /** Most tests hold the kernel for so long, with all that a processor can do. */
  private static final Duration SHORT = Duration.ofMillis(300);

  /** For a job that may take long on a slow machine, and is not to be ended. */
  private static final Duration LONG = Duration.ofSeconds(1);

  /** Another thread writes to it: who has been ended may learn of that first. */
  private final Told log = new Told();

  private final Kernel kernel = Kernel.builder().log(log::output).maxHold(SHORT).start();

  @AfterEach
  void close() {
    kernel.close();
  }

  /** A client, or a log, that keeps what it is told. */
  private static final class Told implements Client {
    private final StringBuilder text = new StringBuilder();

    @Override
    public synchronized void output(String bytes) {
      text.append(bytes);
      notifyAll();
    }

    @Override
    public void closed() {}

    synchronized void await(Predicate<String> what) throws InterruptedException {
      long end = System.nanoTime() + TestTimeout.LONG.toNanos();
      while (!what.test(text.toString())) {
        long left = end - System.nanoTime();
        assertTrue(left > 0, text::toString);
        TimeUnit.NANOSECONDS.timedWait(this, left);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "while| (true) {};",
        "function f(n) { if (n < 2) n else f(n - 1) + f(n - 2) }; f(60);",
        "function z() { try { z } catch { z } }; z;",
        "function z() { try { z } finally { z } }; z;",
        "try { loop| {} } catch { echo(\"caught\") };",
        "detach({ loop| {} });",
      })
  void whoHoldsTheKernelIsEndedAndNamed(String program) throws Exception {
    Told busy = new Told();
    Told judge = new Told();
    kernel.connect(busy).send(program + "\n");
    busy.await(text ->
        text.contains(":error] !!!")
            && text.contains("job shell_")
            && text.contains(" of Lobby_")
            && text.contains("has held the kernel for too long"));
    kernel.connect(judge).send("echo(\"alive\");\n");
    judge.await(text -> text.contains("alive"));
    log.await(text -> text.contains("has held the kernel for more than"));
  }

  @Test
  void theErrorTellsThePlaceAndTheClientGoesOn() throws Exception {
    Told busy = new Told();
    Connection connection = kernel.connect(busy);
    connection.send("function f() { while| (true) f2 };\nfunction f2() { 1 };\nf;\n");
    busy.await(text -> PLACE.matcher(text).find());
    connection.send("echo(\"alive\");\n");
    busy.await(text -> text.contains("alive"));
  }

  @Test
  void codeThatLetsOthersRunMayTakeAsLongAsItLikes() throws Exception {
    Told patient = new Told();
    kernel.connect(patient).send("for (300) { for| (10000) 1; sleep(1ms) }; echo(\"done\");\n");
    patient.await(text -> text.contains("done") || text.contains("!!!"));
    patient.await(text -> text.contains("done"));
  }

  @Test
  void aFunctionOfJavaIsNamedAndInterrupted() throws Exception {
    kernel.define(
        "spin",
        nothing -> {
          while (!Thread.currentThread().isInterrupted()) {
            Thread.onSpinWait();
          }
          return null;
        });
    Told busy = new Told();
    Connection connection = kernel.connect(busy);
    connection.send("spin;\n");
    busy.await(text -> text.contains(", in spin, has held the kernel for too long"));
    connection.send("echo(\"alive\");\n");
    busy.await(text -> text.contains("alive"));
  }

  /** A component with functions that never return by themselves. */
  public static final class Stubborn extends UObject {
    public Stubborn(String name) {
      super(name);
      UBindFunction(this, "waits");
      UBindFunction(this, "spins");
    }

    /** Waits for what nobody brings about. */
    public int waits() throws InterruptedException {
      new CountDownLatch(1).await();
      return 0;
    }

    /** Does not even wait. */
    public int spins() {
      while (!Thread.currentThread().isInterrupted()) {
        Thread.onSpinWait();
      }
      return 0;
    }
  }

  @Test
  void aComponentThatDoesNotReturnIsNamedAndInterrupted() throws Exception {
    kernel.start(Stubborn.class);
    Told busy = new Told();
    Connection connection = kernel.connect(busy);
    for (String function : List.of("waits", "spins")) {
      connection.send("Stubborn." + function + ";\n");
      busy.await(text ->
          text.contains(", in Stubborn." + function + ", has held the kernel for too long"));
    }
    connection.send("echo(\"alive\");\n");
    busy.await(text -> text.contains("alive"));
    log.await(text -> text.contains("in Stubborn.waits, has held"));
  }

  @Test
  void closingTheKernelEndsWhatHoldsIt() throws Exception {
    Kernel patient = Kernel.builder().log(line -> {}).start();
    CountDownLatch begun = new CountDownLatch(1);
    patient.define(
        "begun",
        nothing -> {
          begun.countDown();
          return null;
        });
    patient
        .connect(new Told())
        .send("function z() { try { z } finally { loop| {} } }; begun; loop| {};\n");
    begun.await();
    patient.close();
    assertTrue(!patient.isRunning());
  }

  /** Who embeds a kernel need not give it a limit, and its own program is no client. */
  @Test
  void whoComesWhileAKernelWithoutLimitIsHeldCanInterruptIt() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    try (Kernel endless = Kernel.builder().log(log::output).start()) {
      endless.define(
          "begun",
          nothing -> {
            begun.countDown();
            return null;
          });
      endless.connect(new Program()).send("{ begun| loop| {} };\n");
      begun.await();
      Connection operator = endless.connect(new Told());
      String told;
      do {
        told = operator.interrupt("");
      } while (told.startsWith("nobody"));
      assertTrue(told.startsWith("interrupted: job "), told);
    }
  }

  /** What the owner of a server runs. */
  private static final class Program implements Client {
    @Override
    public void output(String bytes) {}

    @Override
    public void closed() {}

    @Override
    public boolean isProgram() {
      return true;
    }
  }

  /** To tell all of them takes longer than the client may. */
  @Test
  void conditionsOfOthersAreToldEvenIfWhoeverTellsThemIsEnded() throws Exception {
    try (Kernel patient = Kernel.builder().log(log::output).maxHold(LONG).start()) {
      Told busy = new Told();
      Told judge = new Told();
      Connection client = patient.connect(busy);
      client.send(
          "var Global.x = 0; for (var i : 20000) { at (Global.x > 0) {} }; echo(\"set\");\n");
      busy.await(text -> text.contains("set"));
      patient
          .connect(judge)
          .send(
              "at (Global.x > 0) echo(\"told\"); echo(\"ready\"); at (Global.x > 1) echo(\"more\");\n");
      judge.await(text -> text.contains("ready"));
      client.send("lobby.setBudget(\"hold\", 2); sleep(200ms); Global.x = 1; echo(\"end\");\n");
      busy.await(text -> text.contains("has held the kernel for too long") && text.contains("end"));
      judge.await(text -> text.contains("told"));
      patient.connect(judge).send("Global.x = 2;\n");
      judge.await(text -> text.contains("more"));
    }
  }
}
