package org.urbi.tests.failure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;
import urbi.LockMode;
import urbi.UObject;

/** Components and embedding programs that throw exceptions and errors of all kinds. */
class ComponentFailureTest {
  private final BlockingQueue<String> output = new LinkedBlockingQueue<>();
  private final ByteArrayOutputStream log = new ByteArrayOutputStream();
  private final PrintStream before = System.err;
  private Kernel kernel;

  /** Throws in each of its functions. */
  public static class FailingObject extends UObject {
    public FailingObject(String name) {
      super(name);
      UBindFunctions("assertion", "missing", "exception", "refuses", "refusesLater");
      UBindThreadedFunction("later", LockMode.LOCK_NONE);
      UBindFunctions("begin");
    }

    public int assertion() {
      throw new AssertionError("broken");
    }

    public int missing() {
      throw new NoClassDefFoundError("org/nowhere/Thing");
    }

    public int exception() {
      throw new UnsupportedOperationException("no arm");
    }

    public int refuses() {
      throw new Refusal();
    }

    public CompletionStage<Integer> refusesLater() {
      return CompletableFuture.<Integer>failedFuture(new Refusal()).thenApply(any -> any);
    }

    public int later() {
      throw new AssertionError("broken");
    }

    public int begin() {
      USetTimer(1, this, "assertion");
      return 0;
    }
  }

  /** For whoever asks, who is not interested in where it comes from. */
  private static final class Refusal extends IllegalStateException {
    private static final long serialVersionUID = 1;

    Refusal() {
      super("ask again tomorrow");
    }

    @Override
    public synchronized Throwable fillInStackTrace() {
      return this;
    }
  }

  @BeforeEach
  void start() {
    System.setErr(new PrintStream(log, true, StandardCharsets.UTF_8));
    kernel = Kernel.builder().output(output::add).start();
    kernel.start(FailingObject.class);
  }

  @AfterEach
  void end() {
    kernel.close();
    System.setErr(before);
  }

  private String log() {
    return log.toString(StandardCharsets.UTF_8);
  }

  private void assertLogged(String... parts) {
    for (String part : parts) {
      assertTrue(log().contains(part), this::log);
    }
  }

  private String thrownBy(String code) {
    String message = assertThrows(UrbiError.class, () -> kernel.eval(code)).getMessage();
    assertEquals(3.0, kernel.eval("1 + 2"), "the kernel goes on");
    return message;
  }

  @ParameterizedTest
  @ValueSource(strings = {"assertion", "later"})
  void errorOfAComponentIsInternal(String function) {
    String told = thrownBy("FailingObject." + function);
    assertTrue(told.endsWith("internal error: java.lang.AssertionError: broken"), told);
    assertLogged("java.lang.AssertionError: broken", "\tat " + FailingObject.class.getName());
  }

  @Test
  void exceptionOfAComponentIsReportedByItsMessage() {
    String told = thrownBy("FailingObject.exception");
    assertTrue(told.endsWith("UnsupportedOperationException: no arm"), told);
    assertLogged(
        "exception caught while calling FailingObject.exception",
        "java.lang.UnsupportedOperationException: no arm",
        "\tat " + FailingObject.class.getName());
  }

  @ParameterizedTest
  @ValueSource(strings = {"refuses", "refusesLater"})
  void whatAComponentRefusesIsForTheOneWhoAsks(String function) {
    String told = thrownBy("FailingObject." + function);
    assertTrue(told.endsWith("FailingObject." + function + ": ask again tomorrow"), told);
    assertEquals("", log());
  }

  @Test
  void missingClassOfAComponentIsInternal() {
    String told = thrownBy("FailingObject.missing");
    assertTrue(
        told.endsWith("internal error: java.lang.NoClassDefFoundError: org/nowhere/Thing"), told);
    assertLogged("\tat " + FailingObject.class.getName());
  }

  @Test
  void failingTimerIsReportedAndLogged() throws Exception {
    kernel.eval("var Global.breaker = FailingObject.new; breaker.begin");
    String told = output.take();
    assertTrue(told.contains("internal error: java.lang.AssertionError: broken"), told);
    assertLogged("java.lang.AssertionError: broken", "\tat " + FailingObject.class.getName());
    assertEquals(3.0, kernel.eval("1 + 2"));
  }

  @Test
  void errorOfTheEmbeddingProgramIsInternal() {
    kernel.define("assertion", arguments -> fail(() -> new AssertionError("broken")));
    assertEquals("internal error: java.lang.AssertionError: broken", thrownBy("assertion"));
    assertLogged("internal error in an evaluation", "java.lang.AssertionError: broken");
  }

  @Test
  void listenerThatFailsIsLogged() throws Exception {
    kernel.eval("var e = Event.new");
    var heard = new LinkedBlockingQueue<Object>();
    kernel.onEvent(
        "e",
        payload -> {
          heard.add(payload);
          throw new AssertionError("deaf");
        });
    kernel.eval("e!(1); e!(2)");
    heard.take();
    // It is told of what follows.
    heard.take();
    assertLogged("exception caught while delivering to a listener", "AssertionError: deaf");
  }

  private static Object fail(Supplier<? extends Error> failure) {
    throw failure.get();
  }
}
