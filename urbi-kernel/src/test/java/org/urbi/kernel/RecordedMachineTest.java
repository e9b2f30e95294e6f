package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.trust.Role;

/** What a run has learned of its machine is in its recording. */
class RecordedMachineTest {
  @TempDir Path folder;

  /** A machine of another kind, with the Java of somebody else, runs it again. */
  @Test
  void aReplayShowsTheRecordedMachine() {
    Path recording = folder.resolve("run");
    try (Kernel kernel = Kernel.builder().virtualTime(true).record(recording).start()) {
      TestClient client = new TestClient(kernel, Role.OWNER);
      String credits = client.say("copyright(true);");
      assertTrue(credits.contains("Provided by " + System.getProperty("java.vendor")), credits);
      client.say("echo(System.Platform.host); echo(System.Platform.kind);");
    }
    String[] names = {"os.arch", "os.name", "java.version", "java.vendor"};
    String[] values = new String[names.length];
    for (int i = 0; i < names.length; i++) {
      values[i] = System.setProperty(names[i], "Haiku");
    }
    try {
      ReplayedRun.check(recording);
    } finally {
      for (int i = 0; i < names.length; i++) {
        System.setProperty(names[i], values[i]);
      }
    }
  }
}
