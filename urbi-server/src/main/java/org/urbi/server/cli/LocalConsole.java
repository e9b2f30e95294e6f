package org.urbi.server.cli;

import static java.util.Objects.requireNonNull;

import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.util.function.BiFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.lobby.ErrorStyle;
import org.urbi.kernel.log.FailureLog;
import org.urbi.server.console.Console;
import org.urbi.server.console.ConsoleOutput;
import org.urbi.server.console.PipeInput;
import org.urbi.server.console.StandardOutput;
import org.urbi.server.console.TerminalSession;

/**
 * The lobby of the program itself. It executes the code in the options, then the input from the
 * terminal or the standard input, and decides when the run is over.
 */
final class LocalConsole implements AutoCloseable {
  /** The exit status of a run with an error that nobody handled. */
  static final int FAILED = 1;

  private final Settings settings;
  private final Kernel kernel;
  private final BiFunction<Client, Boolean, Connection> lobbies;
  private final Runnable end;
  private final ConsoleOutput consoleOutput;
  private final @Nullable TerminalSession terminal;
  private final Console console;
  private final PrintStream err;
  private volatile boolean outputLost;
  private volatile boolean left;
  private @Nullable Connection connection;

  LocalConsole(
      Settings settings,
      Kernel kernel,
      BiFunction<Client, Boolean, Connection> lobbies,
      Runnable end,
      PrintStream out,
      PrintStream err) {
    this.err = err;
    this.settings = settings;
    this.kernel = kernel;
    this.lobbies = lobbies;
    this.end = end;
    boolean session = settings.input() == Settings.Input.SESSION;
    terminal =
        session && Terminal.isBoth()
            ? TerminalSession.open(
                settings.errors() == ErrorStyle.COLOURED, settings.searchPath().directories())
            : null;
    consoleOutput =
        terminal != null
            ? terminal.consoleOutput()
            : new StandardOutput(stream(out), settings.keepsServing(), this::outputLost);
    console = new Console(consoleOutput::add, settings.errors(), this::lobbyClosed);
  }

  /** Makes a stream that reports failures, unlike a print stream. */
  private static OutputStream stream(PrintStream out) {
    return out == System.out ? new FileOutputStream(FileDescriptor.out) : out;
  }

  /** The output cannot be written: a run whose purpose is its output ends. */
  private void outputLost(IOException failure) {
    outputLost = true;
    err.println("urbi: cannot write the output: " + failure.getMessage());
    if (!settings.keepsServing()) {
      kernel.abort(ExitStatus.OUTPUT_LOST);
    }
  }

  /** Whether some output could not be written. The answer is final after {@link #close}. */
  boolean isOutputLost() {
    return outputLost;
  }

  /**
   * Opens the lobby, sends the code in the options, and reads further input on a thread of its own.
   */
  void start() {
    InterruptHandler interrupts =
        new InterruptHandler(this::isSession, () -> opened().interrupt(), this::shutDown);
    if (settings.text().isEmpty() && settings.input() == Settings.Input.NONE) {
      interrupts.install();
      return;
    }
    Connection made = lobbies.apply(console, settings.holdsTime());
    connection = made;
    interrupts.install();
    if (terminal != null) {
      Signals.whenResized(terminal::resized);
      Signals.whenContinued(terminal::continued);
    }
    made.send(settings.text());
    switch (settings.input()) {
      case NONE -> inputEnded();
      case STREAM -> read(this::readStream);
      case SESSION -> read(terminal == null ? this::readStream : () -> converse(interrupts));
    }
  }

  private Connection opened() {
    return requireNonNull(connection, "asked for when the lobby is open");
  }

  /** In a session, acts as if the user had typed {@code shutdown}. */
  private void shutDown() {
    if (isSession()) {
      opened().interrupt();
      opened()
          .send(
              "lobby.send(\"!!! "
                  + Problem.INTERRUPTED_SHUTDOWN.text()
                  + "\", \"error\") | shutdown;\n");
    } else {
      if (connection != null) {
        connection.close();
      }
      end.run();
    }
  }

  private boolean isSession() {
    return settings.input() == Settings.Input.SESSION && console.isOpen();
  }

  private void read(Runnable reader) {
    Runnable guarded =
        () -> {
          try {
            reader.run();
          } catch (Throwable failure) {
            opened().failed("the reading of the input", failure);
            inputEnded();
          }
        };
    FailureLog.THREADS.platform("urbi-input", guarded).start();
  }

  private void readStream() {
    boolean all = settings.fast() && settings.holdsTime();
    new PipeInput(new FileInputStream(FileDescriptor.in), console, opened(), all).run();
    inputEnded();
  }

  private void converse(InterruptHandler interrupts) {
    requireNonNull(terminal, "a conversation has one")
        .run(console, opened(), interrupts::interrupted);
    if (console.isOpen()) {
      leave();
    }
  }

  /** Ends the run; what was typed before is executed before, as far as it does not wait. */
  private void leave() {
    left = true;
    opened().hangUp();
  }

  /**
   * The input has ended: unless there is another source of input, the run ends with its last job.
   */
  private void inputEnded() {
    if (!settings.keepsServing()) {
      opened().end();
    }
  }

  private void lobbyClosed() {
    if (left || !settings.keepsServing()) {
      kernel.requestShutdown(hasFailed() ? FAILED : 0);
    }
  }

  /** Whether the given code had an error. Errors in an interactive session do not count. */
  boolean hasFailed() {
    return settings.input() != Settings.Input.SESSION && console.hasFailed();
  }

  @Override
  public void close() {
    consoleOutput.close();
    if (terminal != null) {
      terminal.close();
    }
  }
}
