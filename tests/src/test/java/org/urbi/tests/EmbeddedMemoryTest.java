package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * A Java program whose kernels fill the memory, or its stacks, gets errors; it does not hang, nor
 * end for it.
 */
class EmbeddedMemoryTest {
  @Test
  void kernelThatFillsTheMemoryHarmsNeitherTheProgramNorItsOtherKernels() throws Exception {
    assertEquals(
        """
        TICK_LOOP: memory exhausted
        TICK_LOOP: 2.0
        BATON: memory exhausted
        BATON: 2.0
        the other one: 3.0
        the watchdog has ended
        """,
        output(KernelsThatFillTheHeap.class, "-Xmx64m", "-XX:+UseSerialGC"));
  }

  /** Jobs whose stacks cannot be put away have threads of their own. */
  @Test
  void kernelThatEndsLeavesNoThreadOfAJob() throws Exception {
    assertEquals(
        """
        with 5 threads closed: 4.0 at the bottom, none left
        with 5 threads shut down: 4.0 at the bottom, none left
        """,
        output(KernelsWithDeepJobs.class, "-Xmx300m", "-XX:+UseG1GC", "-XX:G1HeapRegionSize=1m"));
  }

  private static String output(Class<?> program, String... flags) throws Exception {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of(flags));
    command.add("-XX:TieredStopAtLevel=1");
    command.add("--add-opens=java.base/java.lang=ALL-UNNAMED");
    command.add("-cp");
    // Surefire hides the class path of the tests in a jar.
    command.add(
        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")));
    command.add(program.getName());
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), output);
    return output;
  }
}
