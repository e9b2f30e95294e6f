package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.library.Library;

/**
 * Whatever a builtin is called with, it answers with a value or an exception of the manual, and the
 * kernel goes on. All kernels are confined to a directory made for the test, which {@link
 * WrongCallKernel} has proved before it makes a call.
 *
 * <p>The system properties {@code wrongCalls.seed}, {@code wrongCalls.number} and {@code
 * wrongCalls.only}, the beginning of names such as {@code List.each}, choose the calls.
 */
class WrongCallsTest {
  private static final long SEED = Long.getLong("wrongCalls.seed", 20_250);
  private static final int CALLS = Integer.getInteger("wrongCalls.number", 1_000);
  private static final String ONLY = System.getProperty("wrongCalls.only", "");

  /** Which calls follow which must not depend on the machine. */
  private static final int CALLERS = 4;

  /** One call in so many may spoil the kernel for others, as in {@code Object.protos = []}. */
  private static final int RARE = 100;

  @TempDir Path directory;
  private Path inside;
  private Path outside;

  @BeforeEach
  void makeDirectories() throws IOException {
    inside = Files.createDirectory(directory.toRealPath().resolve("inside"));
    outside = Files.createDirectory(directory.toRealPath().resolve("outside"));
    Files.writeString(outside.resolve("file"), "kept");
  }

  @AfterEach
  void checkOutside() throws IOException {
    assertEquals("kept", Files.readString(outside.resolve("file")));
    try (var all = Files.walk(inside.getParent())) {
      List<Path> elsewhere = all.filter(path -> !path.startsWith(inside)).toList();
      assertEquals(List.of(inside.getParent(), outside, outside.resolve("file")), elsewhere);
    }
  }

  @Test
  void everyBuiltinAnswersWrongCalls() throws Exception {
    PrintStream stderr = System.err;
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    System.setErr(new PrintStream(said, true, StandardCharsets.UTF_8));
    List<String> defects = new ArrayList<>();
    try (var threads = Executors.newFixedThreadPool(CALLERS)) {
      List<Callable<List<String>>> tasks = new ArrayList<>();
      for (int i = 0; i < CALLERS; i++) {
        Path own = Files.createDirectory(inside.resolve("caller" + i));
        List<WrongCaller.Builtin> part = part(i);
        tasks.add(() -> defects(own, part));
      }
      for (Future<List<String>> found : threads.invokeAll(tasks)) {
        defects.addAll(found.get());
      }
    } finally {
      System.setErr(stderr);
    }
    if (!defects.isEmpty()) {
      fail("seed " + SEED + "\n" + String.join("\n", defects));
    }
    assertEquals("", said.toString(StandardCharsets.UTF_8));
  }

  /** The builtins for one of the callers. */
  private static List<WrongCaller.Builtin> part(int caller) {
    List<WrongCaller.Builtin> part = new ArrayList<>();
    int number = 0;
    for (BuiltinTable table : Library.declarations()) {
      for (int i = 0; i < table.size(); i++) {
        var builtin = new WrongCaller.Builtin(table, i);
        if (builtin.toString().startsWith(ONLY) && number++ % CALLERS == caller) {
          part.add(builtin);
        }
      }
    }
    return part;
  }

  private static List<String> defects(Path directory, List<WrongCaller.Builtin> builtins) {
    try (WrongCaller caller = new WrongCaller(directory, SEED)) {
      for (WrongCaller.Builtin builtin : builtins) {
        caller.test(builtin, CALLS);
      }
      if (caller.defects().isEmpty()) {
        checkResults(caller.results(), CALLS * builtins.size());
      }
      return caller.defects();
    }
  }

  /** All calls were made, and not in vain. */
  private static void checkResults(Map<WrongCallKernel.Result, Integer> results, int calls) {
    int sum = results.values().stream().mapToInt(Integer::intValue).sum();
    assertEquals(calls, sum, results.toString());
    int spoilt = results.getOrDefault(WrongCallKernel.Result.SPOILT, 0);
    assertTrue(spoilt <= calls / RARE, results.toString());
    if (calls >= RARE && ONLY.isEmpty()) {
      assertTrue(results.get(WrongCallKernel.Result.VALUE) > calls / RARE, results.toString());
      assertTrue(results.get(WrongCallKernel.Result.EXCEPTION) > calls / RARE, results.toString());
    }
  }
}
