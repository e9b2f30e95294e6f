package org.urbi.tests.process;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;
import org.urbi.tests.TestTimeout;

/**
 * A shell at a pseudo-terminal of the system, whose keyboard and screen are the test's. {@code
 * script} makes it. The command {@code ./urbi} starts the program there.
 */
final class TypedTerminal implements AutoCloseable {
  static final String ENTER = "\r";
  static final String UP = "\u001BOA";
  static final String INTERRUPT = "\u0003";
  static final String END = "\u0004";
  static final String TAB = "\t";
  static final String SUSPEND = "\u001A";

  /** What the command {@code ./urbi} says, at last: who waits for more waits in vain. */
  static final String ENDED = "urbi has ended: ";

  /** How long what must happen may take, in seconds. */
  private static final long PATIENCE = TestTimeout.LONG.toSeconds();

  private final Process process;
  private final StringBuilder screen = new StringBuilder();
  private final Thread reader;
  private boolean over;
  private int seen;

  /** Opens one of 80 columns, in a folder, which is the user's home. */
  TypedTerminal(Path folder, Map<String, String> environment) throws IOException {
    List<String> command =
        JavaProcess.command(
            JavaProcess.Setting.in(folder), "org.urbi.server.cli.UrbiCommand", List.of());
    String words =
        command.stream()
            .filter(word -> !word.startsWith("-Durbi.stdin"))
            .map(word -> "'" + word.replace("'", "'\\''") + "'")
            .collect(Collectors.joining(" "));
    Path urbi = folder.resolve("urbi");
    // The interrupt key is for all that runs there; the shell must live to tell of the end.
    String script = "#!/bin/sh\ntrap : INT\n%s \"$@\"\necho \"%s$?\"\n";
    Files.writeString(urbi, script.formatted(words, ENDED));
    if (!urbi.toFile().setExecutable(true)) {
      throw new IOException("cannot make " + urbi + " executable");
    }
    ProcessBuilder builder =
        new ProcessBuilder(
                "script", "-qf", "-c", "stty rows 24 cols 80; exec /bin/sh -i", "/dev/null")
            .directory(folder.toFile())
            .redirectErrorStream(true);
    Map<String, String> variables = builder.environment();
    variables.keySet().removeIf(name -> name.startsWith("URBI_") || name.equals("ENV"));
    variables.putAll(
        Map.of("TERM", "xterm-256color", "HOME", folder.toString(), "SHELL", "/bin/sh"));
    variables.put("XDG_STATE_HOME", folder.resolve("state").toString());
    variables.putAll(environment);
    process = builder.start();
    Guardian.ofThisJvm().guard(process);
    reader = Thread.ofPlatform().daemon().start(this::read);
  }

  private void read() {
    try (Reader output = new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8)) {
      char[] piece = new char[8192];
      for (int count = output.read(piece); count >= 0; count = output.read(piece)) {
        synchronized (screen) {
          screen.append(piece, 0, count);
          screen.notifyAll();
        }
      }
    } catch (IOException e) {
      // The terminal is gone.
    } finally {
      synchronized (screen) {
        over = true;
        screen.notifyAll();
      }
    }
  }

  /** Presses keys, the letters of a text among them. */
  void type(String text) {
    try {
      process.getOutputStream().write(text.getBytes(StandardCharsets.UTF_8));
      process.getOutputStream().flush();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Types a line. */
  void enter(String line) {
    type(line + ENTER);
  }

  /**
   * Waits until a text appears, behind what was waited for before; returns what came with it. Gives
   * up when the program has ended without it.
   */
  String await(String text) throws InterruptedException {
    long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE);
    synchronized (screen) {
      int found = screen.indexOf(text, seen);
      while (found < 0) {
        long left = TimeUnit.NANOSECONDS.toMillis(deadline - System.nanoTime());
        if (over || left <= 0 || screen.indexOf(ENDED, seen) >= 0) {
          throw new AssertionError(
              "no `" + text + "' in what follows " + seen + " characters of:\n" + screen);
        }
        screen.wait(left);
        found = screen.indexOf(text, seen);
      }
      String shown = screen.substring(seen, found + text.length());
      seen = found + text.length();
      return shown;
    }
  }

  /** Everything that has appeared so far. */
  String text() {
    synchronized (screen) {
      return screen.toString();
    }
  }

  /** Hangs up, as who closes a window does, and waits until nothing runs there any more. */
  @Override
  public void close() throws InterruptedException {
    List<ProcessHandle> running = process.descendants().toList();
    process.destroyForcibly();
    reader.join(TimeUnit.SECONDS.toMillis(PATIENCE));
    for (ProcessHandle left : running) {
      try {
        left.onExit().get(PATIENCE, TimeUnit.SECONDS);
      } catch (ExecutionException | TimeoutException e) {
        left.destroyForcibly();
        throw new AssertionError("outlives its terminal: " + left.info() + "\n" + text(), e);
      }
    }
  }
}
