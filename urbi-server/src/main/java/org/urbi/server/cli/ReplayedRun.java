package org.urbi.server.cli;

import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.urbi.kernel.Client;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.journal.RecordingException;
import org.urbi.server.options.Failure;

/**
 * One run of {@code urbi --replay}: shows the output that the recorded run sent to all its clients.
 */
final class ReplayedRun {
  private static final int DIFFERS = 1;

  private final String file;
  private final PrintStream out;
  private final PrintStream err;

  ReplayedRun(String file, PrintStream out, PrintStream err) {
    this.file = file;
    this.out = out;
    this.err = err;
  }

  /**
   * Replays the run. Returns the status of the recorded run, or 1 if the replay differs from it.
   */
  int run() {
    Kernel kernel;
    try {
      kernel =
          Kernel.builder()
              .topics(UrbiCommand::optionTexts)
              .replay(Path.of(file), number -> new ReplayClient())
              .start();
    } catch (RecordingException e) {
      throw Failure.of(file + " " + e.getMessage());
    } catch (UncheckedIOException e) {
      throw Failure.of("cannot read the recording " + file + ": " + Failure.reason(e));
    }
    int status = kernel.awaitTermination();
    out.flush();
    String difference = kernel.replayDifference();
    if (difference == null) {
      return status;
    }
    err.println("urbi: " + file + ": " + difference);
    return DIFFERS;
  }

  private final class ReplayClient implements Client {
    @Override
    public void output(String bytes) {
      out.writeBytes(bytes.getBytes(StandardCharsets.ISO_8859_1));
    }

    @Override
    public void closed() {}
  }
}
