package org.urbi.kernel.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import urbi.UCastException;
import urbi.wire.WireException;

/** Whose mistake it is that a request has failed. */
class DefectsTest {
  private final ByteArrayOutputStream log = new ByteArrayOutputStream();
  private final PrintStream before = System.err;

  /** Says nothing about where it comes from, as what urbiscript throws. */
  private static final class Traceless extends RuntimeException {
    private static final long serialVersionUID = 1;

    Traceless() {
      super("thrown by code", null, false, false);
    }
  }

  @BeforeEach
  void catchLog() {
    System.setErr(new PrintStream(log, true, StandardCharsets.UTF_8));
  }

  @AfterEach
  void release() {
    System.setErr(before);
  }

  static Stream<Throwable> ours() {
    return Stream.of(
        new NullPointerException("planted"),
        new ClassCastException("planted"),
        new IndexOutOfBoundsException("planted"),
        new AssertionError("planted"),
        new NoClassDefFoundError("planted"));
  }

  @ParameterizedTest
  @MethodSource("ours")
  void bugOfOursIsLogged(Throwable failure) {
    assertTrue(Defects.isDefect(failure));
    assertEquals("internal error: " + failure, Defects.text("a request", failure));
    String logged = log.toString(StandardCharsets.UTF_8);
    assertTrue(logged.contains("internal error in a request"), logged);
    assertTrue(logged.contains("\tat " + DefectsTest.class.getName()), logged);
  }

  static Stream<Throwable> ofOthers() {
    return Stream.of(
        new IllegalArgumentException("no such variable"),
        new IllegalStateException("the process has gone"),
        new UCastException("no number"),
        new WireException("no kind of frame"),
        new Traceless(),
        new StackOverflowError("deep"),
        new OutOfMemoryError("full"));
  }

  @ParameterizedTest
  @MethodSource("ofOthers")
  void whatOthersHaveCausedIsNotLogged(Throwable failure) {
    assertFalse(Defects.isDefect(failure));
    assertEquals(failure.getMessage(), Defects.text("a request", failure));
    assertEquals("", log.toString(StandardCharsets.UTF_8));
  }

  @Test
  void failureWithoutMessageIsNamed() {
    assertEquals(
        "java.lang.IllegalStateException", Defects.text("a request", new IllegalStateException()));
  }
}
