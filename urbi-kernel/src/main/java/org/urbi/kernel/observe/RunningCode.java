package org.urbi.kernel.observe;

import java.util.function.Consumer;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobState;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagStop;
import org.urbi.kernel.library.system.Evaluation;
import org.urbi.kernel.lobby.TopLevel;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.tag.UrbiTag;

/**
 * A text that somebody has written, being run: values and errors are shown as a console shows them,
 * but it has a job and a tag of its own. So it waits for nothing that was run before, and can be
 * stopped with all that it has begun. On the kernel thread.
 */
public final class RunningCode {
  private final Interpreter interpreter;
  private final UrbiLobby by;
  private final UrbiTag tag;
  private final Job job;
  private String error = Problem.WAS_STOPPED.text();

  /**
   * Begins to run it.
   *
   * @param by the lobby of who wants it
   * @param name of the tag
   * @param file the name by which errors call the text
   * @param told when it has ended
   */
  public RunningCode(
      Interpreter interpreter,
      UrbiLobby by,
      String name,
      String file,
      String code,
      Consumer<CodeEnd> told) {
    this.interpreter = interpreter;
    this.by = by;
    this.tag = UrbiTag.named(interpreter, name);
    tag.setOwnerLobby(by);
    this.job =
        interpreter
            .scheduler()
            .startDetached(
                by,
                interpreter.scheduler().rootScope(),
                "studio",
                started -> run(started, file, code));
    job.onEnd(() -> told.accept(new CodeEnd(error, isThere())));
  }

  /** Whether it runs, or something is left that it has begun. */
  public boolean isThere() {
    return job.state() != JobState.ENDED || tag.state().isUsed();
  }

  /** Ends it, and all that it has begun. */
  public void stop() {
    if (tag.state().isUsed()) {
      tag.state().stop(interpreter.scheduler(), interpreter.values().voidObject);
    } else {
      job.terminate();
    }
  }

  private void run(Job started, String file, String code) {
    TagScope connection = started.enter(by.connectionTag().state());
    try {
      TagScope scope = started.enter(tag.state());
      try {
        evaluate(started, file, code);
        error = "";
      } catch (TagStop stop) {
        if (stop.scope() != scope) {
          throw stop;
        }
      } catch (ControlFlowException unwinding) {
        // A return or break outside of functions and loops is ignored, as in a console.
        error = "";
      } catch (Throwable failure) {
        error = Problem.ENDED_BY_ERROR.text();
        interpreter.scheduler().beginTurn();
        interpreter.report(started, failure);
      } finally {
        started.leave(scope);
      }
    } finally {
      started.leave(connection);
    }
  }

  private void evaluate(Job started, String file, String code) {
    Frame frame = Frame.top(interpreter, started, by, new FrameLayout());
    Evaluation.eval(
        frame, null, by, Utf8Text.toUrbi(code), Utf8Text.toUrbi(file), this::showIfWanted);
  }

  private void showIfWanted(Frame frame, UrbiObject value) {
    if (TopLevel.isShown(interpreter, value)) {
      TopLevel.show(frame, by, value);
    }
  }
}
