package org.urbi.server.isolated;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.Kernel;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;

/**
 * A process of a module to which nobody can attend, because no thread could be made, does not run.
 */
class IsolatedProcessTest {
  @TempDir Path folder;

  private static Set<ProcessHandle> children() {
    return ProcessHandle.current().children().collect(Collectors.toSet());
  }

  @ParameterizedTest
  @ValueSource(strings = {"urbi-module-output", "urbi-module-end"})
  void withoutAThreadTheProcessEndsAndItsModuleIsRefused(String refused) throws Exception {
    Files.writeString(folder.resolve("some.so"), "this is no library");
    Consumer<String> nowhere = text -> {};
    Consumer<Thread> begin =
        thread -> {
          if (thread.getName().equals(refused)) {
            throw new OutOfMemoryError("unable to create native thread");
          }
          thread.start();
        };
    Set<ProcessHandle> before = children();
    try (IsolatedProcesses processes =
            new IsolatedProcesses(
                TestTimeout.LONG, Duration.ZERO, new Trace(Trace.Level.NONE, System.err), begin);
        Kernel kernel =
            Kernel.builder()
                .moduleSearchPath(List.of(folder))
                .moduleProcesses(processes)
                .output(nowhere)
                .log(nowhere)
                .start()) {
      assertEquals(
          "the process of some.so has ended: internal error: java.lang.OutOfMemoryError:"
              + " unable to create native thread",
          kernel.eval("try { loadModule(\"some\", \"isolate\") } catch (var e) { e.message };"));
      for (ProcessHandle child : children()) {
        // Not onExit(): its thread is one that all tests of this JVM share, and may block.
        long deadline = System.nanoTime() + TestTimeout.LONG.toNanos();
        while (!before.contains(child) && child.isAlive()) {
          assertTrue(System.nanoTime() < deadline, "the process of the module goes on");
          Thread.sleep(20);
        }
      }
      assertEquals(3.0, kernel.eval("1 + 2;"));
    }
  }
}
