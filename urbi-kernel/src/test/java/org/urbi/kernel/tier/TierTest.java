package org.urbi.kernel.tier;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.node.CompiledCode;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Misses;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** What a tier does when the Java machine gives no more: room, stack, classes. */
class TierTest {
  private final List<String> log = new ArrayList<>();
  private final World world = new World();
  private final Tier tier = new Tier(world, 1, 0, new KernelLog(LogLevel.values()[0], log::add));

  /** Where the stack traces go. */
  private final ByteArrayOutputStream failures = new ByteArrayOutputStream();

  private final PrintStream before = System.err;

  @BeforeEach
  void catchFailures() {
    System.setErr(new PrintStream(failures, true, StandardCharsets.UTF_8));
  }

  @AfterEach
  void release() {
    System.setErr(before);
  }

  /** They are called by name, so who renames one would make loops give back what they need not. */
  @Test
  void quietHelpersAreHelpers() {
    List<String> helpers = new ArrayList<>();
    for (Class<?> each = CompiledCode.class; each != null; each = each.getSuperclass()) {
      Stream.of(each.getDeclaredMethods())
          .filter(method -> Modifier.isStatic(method.getModifiers()))
          .forEach(method -> helpers.add(method.getName()));
    }
    assertEquals(
        List.of(), CodeWriter.QUIET.stream().filter(name -> !helpers.contains(name)).toList());
  }

  /** Code that does nothing. */
  private static final class Nothing extends CompiledCode {
    private final UrbiObject value;

    Nothing(UrbiObject value) {
      super(new Misses(false));
      this.value = value;
    }

    @Override
    public UrbiObject run(Frame frame, double from, double to, UrbiObject[] elements) {
      return value;
    }
  }

  private CompiledCode nothing() {
    return new Nothing(world.values().voidObject);
  }

  private static Supplier<CompiledCode> failing(Throwable failure) {
    return () -> {
      switch (failure) {
        case Error e -> throw e;
        case RuntimeException e -> throw e;
        default -> throw new IllegalArgumentException(failure);
      }
    };
  }

  @Test
  void classesThatAreForgottenMakeRoom() {
    var classes = new ClassesInUse(1000);
    List<CompiledCode> used = new ArrayList<>();
    while (classes.hasRoom()) {
      used.add(nothing());
      classes.add(used.getLast(), 300);
    }
    assertEquals(4, used.size());
    System.gc();
    assertFalse(classes.hasRoom());
    used.removeFirst();
    while (!classes.hasRoom()) {
      System.gc();
    }
    assertEquals(3, used.size());
    classes.add(used.getFirst(), 300);
    assertFalse(classes.hasRoom());
  }

  @Test
  void aMissingClassEndsCompiling() {
    CompiledCode compiled = nothing();
    assertSame(compiled, tier.attempt(() -> compiled));
    assertNull(tier.attempt(failing(new NoClassDefFoundError("java/lang/classfile/Label"))));
    assertNull(tier.attempt(() -> compiled));
    assertEquals(
        List.of(
            "urbi: code is not compiled any more: "
                + "java.lang.NoClassDefFoundError: java/lang/classfile/Label"),
        log);
    assertEquals(2, tier.statistics().refused());
  }

  @Test
  void wantingStackRefusesOnePieceOfCode() {
    assertNull(tier.attempt(failing(new StackOverflowError())));
    assertNotNull(tier.attempt(this::nothing));
    assertTrue(log.isEmpty(), log::toString);
    assertEquals(1, tier.statistics().refused());
  }

  @Test
  void aDefectIsLoggedAndRefusesOnePieceOfCode() {
    assertNull(tier.attempt(failing(new IllegalArgumentException("too far"))));
    assertNull(tier.attempt(failing(new VerifyError("no slot"))));
    assertNotNull(tier.attempt(this::nothing));
    assertEquals(
        List.of(
            "urbi: code is not compiled: java.lang.IllegalArgumentException: too far",
            "urbi: code is not compiled: java.lang.VerifyError: no slot"),
        log);
    String trace = failures.toString(StandardCharsets.UTF_8);
    assertTrue(trace.contains("internal error in the compiler of hot code"), trace);
    assertTrue(trace.contains("\tat " + TierTest.class.getName()), trace);
  }
}
