package org.urbi.kernel.lobby;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.compile.Compilation;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobState;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagStop;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Imports;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.input.Item;
import org.urbi.lang.input.StatementReader;

/**
 * The read-eval-print loop of a lobby: a job that executes the statements of the input one after
 * the other, and shows their values and errors.
 */
public final class Shell {
  /** Notifications of the shell to its connection. */
  public interface Listener {
    /** The shell begins, or ceases, to wait for more input. */
    default void starving(boolean begins) {}

    /** Input has been executed. */
    void consumed();

    /** A syntax error, or an exception that nobody caught, has been shown. */
    default void failed() {}

    /** From now on the input is messages, in which each byte counts. */
    default void binary() {}

    /** Whether the lobby stays when its input and all its jobs are over. */
    default boolean stays() {
      return false;
    }

    /** The lobby is to be closed: its input and all its jobs have ended, or its client has gone. */
    void finished();
  }

  /** Between two looks whether statements wait that nobody may see the end of, in nanoseconds. */
  private static final long LOOK_PERIOD = 1_000_000;

  private final Interpreter interpreter;
  private final UrbiLobby lobby;
  private final StatementReports reports;
  private final Foreground foreground;
  private final Listener listener;
  private StatementReader reader = newReader();
  private final StringBuilder received = new StringBuilder();
  private final Imports imports = new Imports();
  private @Nullable Job job;
  private @Nullable MessageInput messages;
  private boolean textGoesOn;
  private boolean waiting;
  private boolean ended;
  private boolean hungUp;
  private boolean closed;
  private boolean stopped;
  private long bytesReceived;

  /** The number of the statement that it reads or executes, or will read when input comes. */
  private volatile long statement;

  public Shell(Interpreter interpreter, UrbiLobby lobby, Listener listener) {
    this.interpreter = interpreter;
    this.lobby = lobby;
    reports = new StatementReports(interpreter.world(), lobby);
    this.listener = listener;
    foreground = new Foreground(interpreter, lobby, this::isClosed);
  }

  private Job job() {
    return requireNonNull(job, "it has been started");
  }

  private StatementReader newReader() {
    return new StatementReader(null, this::longestStatement, this::letOthersRun);
  }

  /**
   * Called again and again while a statement is read and compiled, which may be a megabyte. Whoever
   * interrupts it has dropped it with the rest of the input.
   */
  private void letOthersRun() {
    StatementReader now = reader;
    job().checkInterrupted();
    job().yield();
    if (reader != now) {
      throw TagStop.interruption();
    }
  }

  private int longestStatement() {
    return (int) Math.min(Integer.MAX_VALUE, lobby.budget().limit(Resource.INPUT));
  }

  /** Starts to execute the input. */
  public void start() {
    job =
        interpreter
            .scheduler()
            .startDetached(lobby, interpreter.scheduler().rootScope(), "shell", this::run);
  }

  /** Takes input. */
  public void receive(String bytes) {
    if (!closed) {
      if (messages == null) {
        received.append(bytes);
      } else {
        messages.receive(bytes);
        listener.consumed();
        answerIfBlocked();
      }
      bytesReceived += bytes.length();
      wake();
    }
  }

  /** Switches from statements to messages. */
  public void switchTo(MessageInput input) {
    messages = input;
    listener.binary();
  }

  /** There will be no more input. */
  public void end() {
    ended = true;
    if (lobby.remoteObjects() != null) {
      lobby.remoteObjects().disconnected();
    }
    wake();
  }

  /**
   * Nobody may be there any more: the lobby ends as soon as the statements must wait. It ends by
   * itself when no statement is left.
   */
  public void hangUp() {
    hungUp = true;
    endOnceItWaits();
  }

  /** A job that looked at each turn would make a loop that is alone ten times as slow. */
  private void endOnceItWaits() {
    if (closed) {
      return;
    }
    if (job().canRun() || foreground.canRun()) {
      Scheduler scheduler = interpreter.scheduler();
      scheduler.timers().add(scheduler.deadline(LOOK_PERIOD), this::endOnceItWaits);
    } else {
      listener.finished();
    }
  }

  /** Whether the input so far ends within a statement. */
  public boolean isIncomplete() {
    return reader.pending();
  }

  public long bytesReceived() {
    return bytesReceived;
  }

  /** The number of characters of input not read yet. */
  public int pending() {
    return messages == null ? received.length() : messages.pending();
  }

  /** Whether it has nothing to do but to wait. */
  public boolean isDaemon() {
    return job().isDaemon();
  }

  /** Whether a job is the one that executes the statements in their turn. */
  public boolean runs(Job one) {
    return one == job;
  }

  /** An error was shown to the client. */
  public void failed() {
    listener.failed();
  }

  private void wake() {
    if (waiting) {
      job().wake();
    }
  }

  /** Ends the statement in the foreground and forgets the input behind it. */
  public void interrupt() {
    received.setLength(0);
    reader = newReader();
    foreground.interrupt();
  }

  /** The number of the last statement that has begun, to be read or executed; from any thread. */
  public long lastStatement() {
    return statement;
  }

  /** Whether a job does what a statement has begun whose number is greater than that. */
  public boolean isAfter(Job one, long last) {
    return one == job && statement > last || one.scope().isAfter(last);
  }

  /**
   * As {@link #interrupt}, and ends also all else that the client has begun, but for what
   * statements have whose numbers are greater than that, and input that is still to be read.
   */
  public void evict(long last) {
    boolean idle = waiting && !reader.pending();
    if (statement <= last && !idle) {
      interrupt();
    }
    lobby
        .connectionTag()
        .state()
        .stopStatements(interpreter.scheduler(), interpreter.values().voidObject, last);
  }

  /** Whether all that the lobby does has been {@linkplain #close ended}. */
  boolean isClosed() {
    return closed;
  }

  /** Ends all that the lobby does. If memory is wanting for that, it can be called again. */
  public void close() {
    closeAlone();
    lobby.closeCreated(interpreter.scheduler());
  }

  /** Ends all that the lobby does, but not the lobbies that its code has made. */
  void closeAlone() {
    closed = true;
    if (!stopped) {
      received.setLength(0);
      // Ends handlers without their onleave clauses: no client is left for them.
      lobby
          .connectionTag()
          .state()
          .abandon(interpreter.scheduler(), interpreter.values().voidObject);
      if (lobby.remoteObjects() != null) {
        lobby.remoteObjects().disconnected();
      }
      if (job != null) {
        job.terminate();
      }
      stopped = true;
    }
  }

  // ------------------------------------------------------------------ in the job

  private void run(Job shell) {
    boolean failedBefore = false;
    try {
      while (!closed) {
        Item item;
        statement++;
        try {
          if (failedBefore) {
            // It may fail again, because memory is exhausted: whoever ends it must have a turn.
            failedBefore = false;
            shell.yieldNow();
          }
          item = nextItem(shell);
        } catch (TagStop stop) {
          interrupted(shell, stop);
          continue;
        } catch (ControlFlowException unwinding) {
          throw unwinding;
        } catch (UrbiException overdue) {
          report(shell, overdue);
          continue;
        } catch (Throwable failure) {
          failed("the reader", failure);
          failedBefore = true;
          continue;
        }
        if (item == null) {
          break;
        }
        item.warnings().forEach(reports::warning);
        if (item instanceof Item.Statement statement) {
          reports.begins(statement);
          execute(shell, statement);
        } else if (item instanceof Item.Invalid invalid) {
          listener.failed();
          reports.errors(invalid.errors());
        }
      }
      if (!closed && !hungUp) {
        awaitJobs(shell);
      }
    } finally {
      listener.finished();
    }
  }

  private @Nullable Item nextItem(Job shell) {
    while (!closed) {
      Item item = reader.next();
      if (item != null) {
        return item;
      }
      if (!received.isEmpty()) {
        String chunk = received.toString();
        received.setLength(0);
        reader.feed(chunk);
        listener.consumed();
      } else if (messages != null && takeNext(shell, messages)) {
        listener.consumed();
      } else if (ended) {
        reports.pauses();
        return reader.unfinished();
      } else {
        reports.pauses();
        waiting = true;
        shell.setDaemon(true);
        listener.starving(true);
        try {
          shell.waitForWake(Wait.INPUT);
          beginsAnew();
        } finally {
          waiting = false;
          shell.setDaemon(false);
          listener.starving(false);
        }
      }
    }
    return null;
  }

  /** What comes now has not begun when it was waited for, unless the input is half a statement. */
  private void beginsAnew() {
    if (!reader.pending()) {
      statement++;
    }
  }

  /** Executes the next message; false if there is none. */
  private boolean takeNext(Job shell, MessageInput messages) {
    MessageInput.Step step = messages.next();
    if (step == null) {
      return false;
    }
    if (step instanceof MessageInput.Text text) {
      textGoesOn = text.goesOn();
      reader.feed(text.code());
      lookForAnswers();
    } else {
      MessageInput.Command order = (MessageInput.Command) step;
      foreground.execute(
          shell,
          statement,
          () -> order.perform(Frame.top(interpreter, shell, lobby, new FrameLayout())),
          () -> {});
    }
    return true;
  }

  /** The running code may wait for an answer that has arrived, but behind other messages. */
  private void lookForAnswers() {
    if (messages != null && messages.hasAnswers()) {
      interpreter.scheduler().atEndOfTick(this::answerIfBlocked);
    }
  }

  private void answerIfBlocked() {
    JobState state = job().state();
    boolean blocked =
        foreground.isBusy() && (state == JobState.WAITING || state == JobState.SLEEPING);
    if (blocked && !closed && messages != null && messages.hasAnswers()) {
      messages.answer();
      listener.consumed();
    }
  }

  private void awaitJobs(Job shell) {
    while (!closed && listener.stays()) {
      shell.setDaemon(true);
      shell.waitForWake(Wait.JOBS);
    }
    shell.setDaemon(false);
    while (!closed && !lobby.connectionTag().state().isIdle()) {
      lobby.connectionTag().state().onIdle(shell::wake);
      shell.waitForWake(Wait.JOBS);
    }
  }

  private void execute(Job shell, Item.Statement statement) {
    Compilation.Compiled compiled;
    try {
      compiled = Compilation.compile(interpreter, statement.tree(), imports, this::letOthersRun);
    } catch (TagStop stop) {
      interrupted(shell, stop);
      return;
    } catch (UrbiException e) {
      report(shell, e);
      return;
    } catch (Throwable failure) {
      failed("the compiler", failure);
      return;
    }
    if (statement.separator() == Ast.Flavor.COMMA) {
      TagScope scope = foreground.enter(shell, this.statement);
      try {
        interpreter
            .scheduler()
            .startDetached(
                lobby,
                scope,
                "shell",
                other ->
                    compiled
                        .code()
                        .execute(Frame.top(interpreter, other, lobby, compiled.layout())));
      } finally {
        shell.leave(scope);
      }
      shell.yieldNow();
      return;
    }
    foreground.execute(
        shell,
        this.statement,
        () -> runAndShow(shell, compiled),
        () -> {
          interpreter.statementOver(Frame.top(interpreter, shell, lobby, compiled.layout()));
          if (lobby.remoteObjects() != null && !textGoesOn) {
            lobby.remoteObjects().statementOver();
          }
        });
  }

  /** A statement was interrupted before it began: the input behind it is dropped, too. */
  private void interrupted(Job shell, TagStop stop) {
    if (closed || !stop.isInterruption()) {
      throw stop;
    }
    foreground.awaitMessage(shell);
  }

  /** Shows what ended a statement before it began; the text may be code that is interrupted. */
  private void report(Job shell, UrbiException ended) {
    try {
      foreground.report(shell, ended);
    } catch (TagStop stop) {
      interrupted(shell, stop);
    }
  }

  /** Reports a bug of ours to the client, and continues. */
  public void failed(String where, Throwable failure) {
    FailureLog.internal(where, failure);
    Diagnostics.error(lobby.output(), FailureLog.text(failure));
  }

  private void runAndShow(Job shell, Compilation.Compiled compiled) {
    Frame frame = Frame.top(interpreter, shell, lobby, compiled.layout());
    UrbiObject value = compiled.code().execute(frame);
    if (TopLevel.isShown(interpreter, value)) {
      TopLevel.show(Frame.top(interpreter, shell, lobby, compiled.layout()), lobby, value);
    }
  }
}
