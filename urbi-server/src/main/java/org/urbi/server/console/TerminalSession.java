package org.urbi.server.console;

import static java.util.Objects.requireNonNull;

import java.io.IOError;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.jline.keymap.KeyMap;
import org.jline.reader.Binding;
import org.jline.reader.EndOfFileException;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.UserInterruptException;
import org.jline.reader.Widget;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Connection;
import org.urbi.kernel.log.FailureLog;
import org.urbi.server.source.SourceText;

/**
 * A session at a terminal: statements are edited, of one line or several, and remembered; output
 * appears above what is being typed.
 */
public final class TerminalSession implements AutoCloseable {
  /** What a line begins with that continues a statement: what is open, and this. */
  private static final String CONTINUED = "%M> ";

  /** What the system has made of a {@code Ctrl-D} that was typed before there was an editor. */
  private static final String END_TYPED_AHEAD = "\0";

  /**
   * How long the next line of what is pasted may take, in milliseconds, on a busy machine: no one
   * types that fast, nor sees that an error is told so late.
   */
  private static final long PASTE_PATIENCE = 100;

  /** What JLine shows in colours of its own. */
  private static final List<String> STYLES =
      List.of(
          LineReader.COMPLETION_STYLE_BACKGROUND,
          LineReader.COMPLETION_STYLE_DESCRIPTION,
          LineReader.COMPLETION_STYLE_GROUP,
          LineReader.COMPLETION_STYLE_STARTING,
          LineReader.COMPLETION_STYLE_LIST_BACKGROUND,
          LineReader.COMPLETION_STYLE_LIST_DESCRIPTION,
          LineReader.COMPLETION_STYLE_LIST_GROUP,
          LineReader.COMPLETION_STYLE_LIST_STARTING);

  private static final String PLAIN_STYLE = "fg:default";

  private final Terminal terminal;
  private final LineReader reader;
  private final FileNames files;
  private volatile @Nullable Connection connection;
  private volatile boolean within;
  private volatile boolean closed;

  /**
   * Opens the terminal of this process. {@code Ctrl-C} is a key for the editor, and a signal at all
   * other times, never both; the process handles signals itself, because the editor would do so
   * anew for each line, and in between a signal would end the process.
   *
   * @param colours whether it shows any
   * @param searchPath where scripts are looked for
   */
  public static TerminalSession open(boolean colours, List<Path> searchPath) {
    System.setProperty(TerminalBuilder.PROP_SOFTWARE_SIGNALS, "false");
    try {
      Terminal terminal =
          TerminalBuilder.builder()
              .system(true)
              .nativeSignals(false)
              .graphemeCluster(false)
              .build();
      return new TerminalSession(terminal, StatementHistory.userFile(), colours, searchPath);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  TerminalSession(Terminal terminal, Path history, boolean colours, List<Path> searchPath) {
    this.terminal = terminal;
    files = new FileNames(searchPath);
    Completions completions = new Completions(this::names);
    LineReaderBuilder builder =
        LineReaderBuilder.builder()
            .appName("urbi")
            .terminal(terminal)
            .variable(LineReader.BLINK_MATCHING_PAREN, 0)
            .variable(LineReader.SECONDARY_PROMPT_PATTERN, CONTINUED)
            // In urbiscript an exclamation mark is an operator, and a backslash stands for itself.
            .option(LineReader.Option.DISABLE_EVENT_EXPANSION, true)
            .parser(new StatementParser(() -> within, this::goesOn))
            .history(new StatementHistory(history, this::tell))
            .completer(completions);
    if (!colours) {
      STYLES.forEach(style -> builder.variable(style, PLAIN_STYLE));
    }
    reader = builder.build();
    completions.attach(reader);
    KeyMap<Binding> keys =
        requireNonNull(reader.getKeyMaps().get(LineReader.MAIN), "every editor has it");
    keys.bind(new Suspension(terminal), KeyMap.ctrl('Z'));
    keys.bind((Widget) this::endTypedAhead, END_TYPED_AHEAD);
  }

  /** Whether more was pasted, or typed, than the line that is being read. */
  private boolean goesOn() {
    try {
      return terminal.reader().peek(PASTE_PATIENCE) >= 0;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Ends the session, unless something is typed: then the key is what it is elsewhere. */
  private boolean endTypedAhead() {
    if (reader.getBuffer().length() == 0) {
      throw new EndOfFileException();
    }
    reader.callWidget(LineReader.SET_MARK_COMMAND);
    return true;
  }

  /** Tells what the session itself has to say. */
  private void tell(String text) {
    terminal.writer().println("urbi: " + text);
    terminal.flush();
  }

  /** Shows output above what is being typed. */
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
   * Reads statements up to {@code Ctrl-D} or the end of the lobby.
   *
   * @param interrupt what {@code Ctrl-C} does in the editor, unless it drops what was typed
   */
  public void run(Console console, Connection connection, Runnable interrupt) {
    this.connection = connection;
    while (console.isOpen()) {
      try {
        within = connection.incomplete();
        String typed = reader.readLine();
        String ending = StatementParser.ending(reader.getParsedLine());
        connection.send(SourceText.bytes(typed) + ending + "\n");
        console.awaitInputConsumed(connection);
      } catch (UserInterruptException e) {
        interrupted(connection, e.getPartialLine(), interrupt);
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

  /**
   * Who drops what was typed ends also what runs in the foreground, but does not want to leave, as
   * often as that is done.
   */
  private static void interrupted(Connection connection, String dropped, Runnable interrupt) {
    if (dropped.isBlank()) {
      interrupt.run();
    } else {
      connection.interrupt();
    }
  }

  /** Shows what is being typed as the terminal is now: its size has changed. */
  public void resized() {
    terminal.raise(Terminal.Signal.WINCH);
  }

  /** Goes on where the shell has given the terminal back. */
  public void continued() {
    terminal.raise(Terminal.Signal.CONT);
  }

  /** What the word at the end of a text may become: a name in a string is that of a file. */
  private CompletableFuture<? extends Collection<String>> names(String text) {
    Connection asked = connection;
    if (asked == null) {
      return CompletableFuture.completedFuture(List.of());
    }
    return FileNames.typed(text) == null
        ? asked.complete(SourceText.bytes(text))
        : CompletableFuture.supplyAsync(
            () -> files.of(text), FailureLog.THREADS.virtualThreads("urbi-file-names"));
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
}
