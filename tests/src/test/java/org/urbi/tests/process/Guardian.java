package org.urbi.tests.process;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * Ends the processes that tests have started when this JVM is gone, even if it was killed: servers
 * go on without those who have started them. It is a shell that notes their numbers, and reads from
 * a pipe that the system closes with the JVM.
 */
final class Guardian implements AutoCloseable {
  private static final String SCRIPT =
      """
      trap '' HUP INT TERM
      all=' '
      while read -r what number; do
        case $what in
          begun) all="$all$number " ;;
          ended) all="${all%% $number *} ${all#* $number }" ;;
        esac
      done
      for each in $all; do kill -9 "$each"; done
      """;

  private static final Guardian OF_THIS_JVM = new Guardian();

  private final OutputStream told;

  Guardian() {
    try {
      told =
          new ProcessBuilder("/bin/sh", "-c", SCRIPT)
              .directory(Path.of("/").toFile())
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start()
              .getOutputStream();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static Guardian ofThisJvm() {
    return OF_THIS_JVM;
  }

  /** A process has been started; when it has ended, its number may be that of another one. */
  void guard(Process process) throws IOException {
    tell("begun", process);
    process.onExit().thenAccept(this::forget);
  }

  private void forget(Process process) {
    try {
      tell("ended", process);
    } catch (IOException e) {
      // Nobody is guarded any more.
    }
  }

  private synchronized void tell(String what, Process process) throws IOException {
    told.write((what + " " + process.pid() + "\n").getBytes(StandardCharsets.US_ASCII));
    told.flush();
  }

  /** What happens when the JVM ends. */
  @Override
  public void close() throws IOException {
    told.close();
  }
}
