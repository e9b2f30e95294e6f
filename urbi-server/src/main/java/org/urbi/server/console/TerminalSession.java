package org.urbi.server.console;

import java.io.IOError;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jline.reader.Candidate;
import org.jline.reader.EndOfFileException;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.ParsedLine;
import org.jline.reader.UserInterruptException;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Connection;
import org.urbi.server.source.SourceText;

/**
 * A session at a terminal: lines are edited and remembered, output appears above the line that is
 * being typed.
 */
public final class TerminalSession implements AutoCloseable {
  private static final String CONTINUED = "  ";

  /** How long a completion waits for a busy kernel. */
  private static final int TIMEOUT_MS = 500;

  private final Terminal terminal;
  private final LineReader reader;
  private volatile @Nullable Connection connection;
  private volatile boolean closed;

  public TerminalSession() {
    try {
      terminal = TerminalBuilder.builder().system(true).graphemeCluster(false).build();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    reader =
        LineReaderBuilder.builder()
            .appName("urbi")
            .terminal(terminal)
            .variable(LineReader.HISTORY_FILE, historyFile())
            .variable(LineReader.BLINK_MATCHING_PAREN, 0)
            // In urbiscript an exclamation mark is an operator, and a backslash stands for itself.
            .option(LineReader.Option.DISABLE_EVENT_EXPANSION, true)
            .parser(new SingleWordParser())
            .completer((from, line, candidates) -> complete(line, candidates))
            .build();
  }

  /** Shows output above the line that is being typed. */
  public ConsoleOutput consoleOutput() {
    return new StandardOutput(
        new OutputStream() {
          @Override
          public void write(int b) {
            write(new byte[] {(byte) b}, 0, 1);
          }

          @Override
          public void write(byte[] bytes, int offset, int length) {
            reader.printAbove(new String(bytes, offset, length, StandardCharsets.UTF_8));
          }
        },
        true,
        failure -> {});
  }

  /**
   * Reads lines up to {@code Ctrl-D} or the end of the lobby.
   *
   * @param interrupt what {@code Ctrl-C} does
   */
  public void run(Console console, Connection connection, Runnable interrupt) {
    this.connection = connection;
    terminal.handle(Terminal.Signal.INT, signal -> interrupt.run());
    while (console.isOpen()) {
      try {
        String line = reader.readLine(connection.incomplete() ? CONTINUED : "");
        connection.send(SourceText.bytes(line) + "\n");
        console.awaitInputConsumed(connection);
      } catch (UserInterruptException e) {
        interrupt.run();
      } catch (EndOfFileException e) {
        return;
      } catch (IllegalStateException | IOError e) {
        if (!closed) {
          throw e;
        }
        return;
      }
    }
  }

  /** Adds the completions of the name before the cursor; none when the kernel is too busy. */
  private void complete(ParsedLine line, List<Candidate> candidates) {
    Connection asked = connection;
    if (asked == null) {
      return;
    }
    try {
      String typed = SourceText.bytes(line.line().substring(0, line.cursor()));
      for (String name : asked.complete(typed).get(TIMEOUT_MS, TimeUnit.MILLISECONDS)) {
        candidates.add(new Candidate(name, name, null, null, null, null, false));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException | TimeoutException e) {
      // No completions.
    }
  }

  /** Restores the terminal; a thread that still reads from it sees the end of the input. */
  @Override
  public void close() {
    closed = true;
    try {
      terminal.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Path historyFile() {
    String state = System.getenv("XDG_STATE_HOME");
    if (state != null && !state.isEmpty()) {
      return Path.of(state, "urbi", "history");
    }
    String home = System.getenv("HOME");
    return Path.of(home == null ? System.getProperty("user.home") : home, ".urbi_history");
  }
}
