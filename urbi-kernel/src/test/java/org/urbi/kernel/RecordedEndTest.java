package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.urbi.kernel.trust.Role;

/** A program that ends by itself, and with which status, is had again from the recording. */
class RecordedEndTest {
  private static final int FAILED = 4;

  /** The main program: the kernel ends with it. */
  private static final class Program implements Client {
    private final Kernel kernel;
    private boolean failed;

    Program(Kernel kernel) {
      this.kernel = kernel;
    }

    @Override
    public boolean isProgram() {
      return true;
    }

    @Override
    public void failed() {
      failed = true;
    }

    @Override
    public void output(String bytes) {}

    @Override
    public void closed() {
      kernel.requestShutdown(failed ? FAILED : 0);
    }
  }

  /** Looks on, and keeps no kernel running. */
  private static final class Observer implements Client {
    @Override
    public boolean isAwaited() {
      return false;
    }

    @Override
    public Role role() {
      return Role.OBSERVER;
    }

    @Override
    public void output(String bytes) {}

    @Override
    public void closed() {}
  }

  @TempDir Path folder;
  private Path recording;

  private int recorded(String source, Client... others) {
    recording = folder.resolve("run");
    try (Kernel kernel = Kernel.builder().virtualTime(true).record(recording).start()) {
      for (Client other : others) {
        kernel.connect(other, false);
      }
      Connection connection = kernel.connect(new Program(kernel));
      connection.send(source);
      connection.end();
      return kernel.awaitTermination();
    }
  }

  /** The clients of the replay know nothing of those of the run. */
  private int replayed() {
    Kernel kernel = ReplayedRun.ended(Kernel.builder(), recording);
    assertNull(kernel.replayDifference());
    return kernel.awaitTermination();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0|echo(1);",
        "0|var x = 1; at (x > 1) echo(x);",
        "0|{ sleep(1h); echo(2) }, lobby.connectionTag;",
        "0|disown({ sleep(1h); echo(2) });",
        "0|quit;",
        "0|at (lobby.onDisconnect?) echo(3); echo(4);",
        "4|1 +;",
        "4|{ sleep(1h); throw 1 },",
        "3|shutdown(3);",
      })
  void theEndAndItsStatus(int status, String source) {
    assertEquals(status, recorded(source));
    assertEquals(status, replayed());
  }

  @Test
  void whoOnlyLooksOnKeepsNeitherOfThem() {
    assertEquals(0, recorded("sleep(1s); echo(1);", new Observer()));
    assertEquals(0, replayed());
  }
}
