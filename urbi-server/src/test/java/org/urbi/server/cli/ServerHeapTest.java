package org.urbi.server.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.sun.management.HotSpotDiagnosticMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** In a process of its own: the collector is that of the whole JVM. */
class ServerHeapTest {
  private static final long MIB = 1 << 20;

  /** Prints how much of the memory is used before garbage is collected, in MiB. */
  static final class Program {
    private Program() {}

    public static void main(String[] arguments) {
      ServerHeap.keepRoom();
      String limit =
          ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean.class)
              .getVMOption("SoftMaxHeapSize")
              .getValue();
      System.out.println(Long.parseLong(limit) / MIB);
    }
  }

  private static String limit(String... flags) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of(flags));
    command.addAll(List.of("-Xmx64m", "-cp", System.getProperty("java.class.path")));
    command.add(Program.class.getName());
    Process java = new ProcessBuilder(command).redirectErrorStream(true).start();
    String text = new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, java.waitFor(), text);
    return text.strip();
  }

  @Test
  void aCollectorThatWorksBesideTheProgramBeginsEarly() throws Exception {
    assertEquals("32", limit("-XX:+UseZGC"));
  }

  @Test
  void whatTheUserHasSetStays() throws Exception {
    assertEquals("48", limit("-XX:+UseZGC", "-XX:SoftMaxHeapSize=48m"));
  }

  @Test
  void anotherCollectorHasAllTheMemory() throws Exception {
    assertEquals("64", limit("-XX:+UseSerialGC"));
  }
}
