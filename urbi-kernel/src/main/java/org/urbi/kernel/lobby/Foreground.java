package org.urbi.kernel.lobby;

import java.util.function.BooleanSupplier;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagStop;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.tag.UrbiTag;

/** What the shell of a lobby executes itself, for which the input behind it waits. */
final class Foreground {
  private final Interpreter interpreter;
  private final UrbiLobby lobby;
  private final BooleanSupplier closed;
  private UrbiTag tag;
  private boolean busy;

  Foreground(Interpreter interpreter, UrbiLobby lobby, BooleanSupplier closed) {
    this.interpreter = interpreter;
    this.lobby = lobby;
    this.closed = closed;
    tag = newTag();
  }

  private UrbiTag newTag() {
    return (UrbiTag) interpreter.prototypes().tag.cloned();
  }

  /** Whether something is executed. */
  boolean isBusy() {
    return busy;
  }

  /** Whether something is executed that does not wait. */
  boolean canRun() {
    return busy && tag.state().canRun();
  }

  /** Ends what is executed, and tells so. */
  void interrupt() {
    if (busy) {
      tag.state().stop(interpreter.scheduler(), interpreter.values().voidObject);
      Diagnostics.error(lobby.output(), Problem.INTERRUPTED.text());
    }
  }

  /**
   * Enters the tag of the connection.
   *
   * @param statement the number of the statement that is executed in it
   */
  TagScope enter(Job shell, long statement) {
    TagScope scope = shell.enter(lobby.connectionTag().state());
    scope.isForStatement(statement);
    return scope;
  }

  /**
   * Executes the action of a statement.
   *
   * @param end what follows if no error has ended it
   */
  void execute(Job shell, long statement, Runnable action, Runnable end) {
    busy = true;
    boolean interrupted = false;
    tag = newTag();
    try {
      TagScope scope = enter(shell, statement);
      try {
        if (runsToEnd(shell, action)) {
          end.run();
        }
        shell.yield();
      } catch (TagStop stop) {
        interrupted = isInterruption(stop);
      } catch (ControlFlowException unwinding) {
        // A return or break outside of functions and loops is ignored.
      } catch (Throwable failure) {
        interpreter.scheduler().memory().recover(failure);
        interrupted = isInterruptedByReport(shell, failure);
      } finally {
        shell.leave(scope);
      }
      if (interrupted) {
        // Called outside of the lobby's tag, because the message may stop everything under it.
        awaitMessage(shell);
      }
    } finally {
      busy = false;
      shell.endNonInterruptible(0);
    }
  }

  /**
   * Runs something under the tag of the foreground, its errors included: whoever interrupts it ends
   * also the code that tells what was thrown. Returns whether no error has ended it.
   */
  private boolean runsToEnd(Job shell, Runnable action) {
    TagScope scope = shell.enter(tag.state());
    try {
      action.run();
      return true;
    } catch (TagStop stop) {
      if (stop.scope() != scope) {
        throw stop;
      }
      return true;
    } catch (ControlFlowException unwinding) {
      throw unwinding;
    } catch (Throwable failure) {
      report(shell, failure);
      return false;
    } finally {
      shell.leave(scope);
    }
  }

  /** Shows what has ended a statement, or its reader, in a turn of its own: not held any more. */
  void report(Job shell, Throwable failure) {
    interpreter.scheduler().beginTurn();
    interpreter.report(shell, failure);
  }

  private boolean isInterruption(TagStop stop) {
    if (closed.getAsBoolean()) {
      throw stop;
    }
    return stop.isInterruption();
  }

  /** Shows what has ended a statement; its text may be code of users, too. */
  private boolean isInterruptedByReport(Job shell, Throwable failure) {
    try {
      report(shell, failure);
      return false;
    } catch (TagStop stop) {
      return isInterruption(stop);
    }
  }

  /**
   * After an interruption the input behind must not be executed: wait for the message that drops
   * it.
   */
  void awaitMessage(Job shell) {
    do {
      shell.yieldNow();
    } while (!closed.getAsBoolean() && interpreter.scheduler().interruptions().isMessageDue(lobby));
  }
}
