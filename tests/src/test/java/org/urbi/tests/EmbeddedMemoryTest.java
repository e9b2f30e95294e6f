package org.urbi.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A Java program whose kernels fill the memory gets errors; it does not hang, nor end for it. */
class EmbeddedMemoryTest {
  @Test
  void kernelThatFillsTheMemoryHarmsNeitherTheProgramNorItsOtherKernels() throws Exception {
    // Surefire hides the class path of the tests in a jar.
    String classes =
        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
    List<String> command =
        List.of(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-Xmx64m",
            "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1",
            "--add-opens=java.base/java.lang=ALL-UNNAMED",
            "-cp",
            classes,
            KernelsThatFillTheHeap.class.getName());
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(
        """
        TICK_LOOP: memory exhausted
        TICK_LOOP: 2.0
        BATON: memory exhausted
        BATON: 2.0
        the other one: 3.0
        the watchdog has ended
        """,
        output);
    assertEquals(0, process.waitFor());
  }
}
