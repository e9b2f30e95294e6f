package org.urbi.ros.rtps;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.urbi.ros.Awaited;
import org.urbi.ros.Lines;

/** Tests that are killed leave no peers behind, which would go on to talk in their domain. */
class NurseryTest {
  private static final String ENVIRONMENT = "jazzy";

  /** As tests that have started a peer, which is in the middle of something. */
  static final class Tests {
    private Tests() {}

    /** Tells the processes that it has started, and waits to be killed. */
    public static void main(String[] arguments) throws Exception {
      Peer peer = new Peer(ENVIRONMENT, Integer.parseInt(arguments[0]));
      peer.say("subscribe nobody_sends 1");
      peer.expect("subscribed");
      System.out.println(
          ProcessHandle.current()
              .descendants()
              .map(each -> String.valueOf(each.pid()))
              .collect(Collectors.joining(" ")));
      System.in.read();
    }
  }

  @Test
  void peersEndWithTheTests() throws Exception {
    Peer.assumeThere(ENVIRONMENT);
    try (Neighbourhood domain = new Neighbourhood()) {
      String classes =
          System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
      Process tests =
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-cp",
                  classes,
                  Tests.class.getName(),
                  Integer.toString(domain.domain))
              .redirectError(ProcessBuilder.Redirect.INHERIT)
              .start();
      List<ProcessHandle> started;
      try {
        String numbers = new Lines(tests.inputReader()).next();
        started =
            Stream.of(numbers.split(" "))
                .flatMap(each -> ProcessHandle.of(Long.parseLong(each)).stream())
                .toList();
      } finally {
        tests.destroyForcibly();
      }
      assertEquals(2, started.size(), "the one that forks, and the peer");
      for (ProcessHandle each : started) {
        Awaited.until("the end of " + each.pid(), () -> !each.isAlive());
      }
    }
  }
}
