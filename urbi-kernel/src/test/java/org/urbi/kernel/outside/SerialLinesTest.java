package org.urbi.kernel.outside;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.TestClient;
import org.urbi.kernel.trust.Role;

/** Serial lines, with devices at their other ends that say something, or nothing. */
class SerialLinesTest {
  private static final Path SCRIPT = Path.of("/usr/bin/script");

  private final Kernel kernel = Kernel.builder().log(line -> {}).start();
  private final TestClient client = new TestClient(kernel, Role.OWNER);
  private Process device;
  private BufferedReader written;

  /** A terminal of its own, whose name it tells, and then what is written to it. */
  @BeforeEach
  void connect() throws IOException {
    assumeTrue(Files.isExecutable(SCRIPT), "there is no " + SCRIPT);
    device =
        new ProcessBuilder(SCRIPT.toString(), "-qfc", "tty; exec sleep inf", "/dev/null").start();
    written = new BufferedReader(new InputStreamReader(device.getInputStream(), US_ASCII));
    String line = written.readLine();
    assertEquals(
        "",
        client.say(
            "var s = Socket.new|; var got = \"\"|; var gone = 0|;"
                + " at (s.received?(var data)) got += data; at (s.disconnected?) gone += 1;"
                + " s.connectSerial(\""
                + line
                + "\", 9600);"));
    while (!isReading()) {
      Thread.onSpinWait();
    }
  }

  @AfterEach
  void end() throws InterruptedException {
    kernel.close();
    if (device != null) {
      device.destroyForcibly().waitFor();
    }
  }

  /** Whether a thread waits for the device, or goes to. */
  private static boolean isReading() {
    return isExecuted(SocketConnection.class, "read");
  }

  private static boolean isWriting() {
    return isExecuted(PipeSink.class, "writeAll");
  }

  private static boolean isExecuted(Class<?> type, String method) {
    return Thread.getAllStackTraces().values().stream()
        .flatMap(Arrays::stream)
        .anyMatch(frame ->
            frame.getClassName().equals(type.getName()) && frame.getMethodName().equals(method));
  }

  private static void awaitEndOf(BooleanSupplier work) {
    while (work.getAsBoolean()) {
      Thread.onSpinWait();
    }
  }

  @Test
  void bothSidesHearEachOther() throws IOException {
    device.getOutputStream().write("hello".getBytes(US_ASCII));
    device.getOutputStream().flush();
    assertEquals("\"hello\"", client.say("waituntil (got.length == 5); got;"));
    client.say("s.write(\"to the device\\n\");");
    assertEquals("to the device", written.readLine());
  }

  @Test
  void aLineToASilentDeviceThatIsClosedLeavesNoThread() {
    client.say("s.disconnect;");
    awaitEndOf(SerialLinesTest::isReading);
    assertEquals("1", client.say("waituntil (gone == 1); gone;"));
    assertEquals("false", client.say("s.isConnected;"));
  }

  /** What was written waits until the device takes it, or the kernel has ended. */
  @Test
  void norDoesOneToADeviceThatTakesNothing() throws Exception {
    assertEquals(0, new ProcessBuilder("kill", "-STOP", device.pid() + "").start().waitFor());
    client.say("s.write(\"x\" * 100000)|; s.disconnect;");
    awaitEndOf(SerialLinesTest::isReading);
    assertEquals("1", client.say("waituntil (gone == 1); gone;"));
    assertTrue(isWriting());
    kernel.close();
    awaitEndOf(SerialLinesTest::isWriting);
  }

  @Test
  void norDoesOneOfAKernelThatHasEnded() {
    assertTrue(isReading());
    kernel.close();
    awaitEndOf(SerialLinesTest::isReading);
    assertFalse(kernel.isRunning());
  }
}
