package org.urbi.kernel.observe;

import java.util.function.Consumer;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.library.system.Evaluation;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.lang.parse.UrbiParser;

/**
 * Does in urbiscript what people who look at a kernel want: in a job of their lobby, with its role
 * and budget, which others see and can stop like any other. On the kernel thread.
 */
public final class Interventions {
  @FunctionalInterface
  private interface Work {
    void run(Frame frame);
  }

  /** By what errors call the code of people who look. */
  private static final String STUDIO = "studio";

  private final Interpreter interpreter;
  private final KnownEvents events;
  private final Places places;

  public Interventions(Interpreter interpreter, KnownEvents events, Places places) {
    this.interpreter = interpreter;
    this.events = events;
    this.places = places;
  }

  /**
   * Emits an event.
   *
   * @param by the lobby of who wants it
   * @param number of the event
   * @param payload expressions of urbiscript, separated by commas
   * @param answer told what went wrong, or an empty text, when it has been emitted
   */
  public void emit(UrbiLobby by, long number, String payload, Consumer<String> answer) {
    UrbiEvent event = events.event(number);
    if (event == null) {
      answer.accept(Problem.NO_SUCH_EVENT.text(number));
      return;
    }
    begin(
        by,
        answer,
        frame -> {
          UrbiObject values = evaluate(frame, by, list(frame, payload));
          if (!(values instanceof UrbiList list)) {
            throw interpreter.errors().primitive("emit", Problem.NO_PAYLOAD);
          }
          interpreter.send(frame, event, "emit", list.elements().toArray(UrbiObject[]::new));
        });
  }

  /**
   * Assigns a slot, as urbiscript does.
   *
   * @param by the lobby of who wants it
   * @param way to the slot, as {@link Places} says
   * @param code an expression of urbiscript
   * @param answer told what went wrong, or an empty text, when it has been assigned
   */
  public void assign(UrbiLobby by, String way, String code, Consumer<String> answer) {
    Places.Slot slot = places.slot(way);
    if (slot == null) {
      answer.accept(Problem.NO_SUCH_SLOT.text(Places.shown(way)));
      return;
    }
    begin(
        by,
        answer,
        frame -> {
          UrbiObject value = evaluate(frame, by, code);
          if (value == interpreter.values().voidObject) {
            throw interpreter.errors().unexpectedVoid();
          }
          SlotUpdate.assign(frame, slot.holder(), slot.name(), value);
        });
  }

  /**
   * The code of the list of what an event is emitted with. If people have not finished to type it,
   * it is left as it is: its error must not speak of a bracket that they have not typed.
   */
  private static String list(Frame frame, String payload) {
    String list = "[" + payload + "\n]";
    return isSound(frame, list) || isSound(frame, payload) ? list : payload;
  }

  private static boolean isSound(Frame frame, String code) {
    Runnable interruption = frame.job()::checkInterrupted;
    return UrbiParser.parse(Utf8Text.toUrbi(code), STUDIO, interruption).errors().isEmpty();
  }

  private static UrbiObject evaluate(Frame frame, UrbiLobby by, String code) {
    return Evaluation.eval(frame, null, by, Utf8Text.toUrbi(code), STUDIO);
  }

  private void begin(UrbiLobby by, Consumer<String> answer, Work work) {
    String[] outcome = {Problem.WAS_STOPPED.text()};
    interpreter
        .scheduler()
        .startDetached(
            by,
            interpreter.scheduler().rootScope(),
            STUDIO,
            job -> outcome[0] = outcome(by, job, work))
        .onEnd(() -> answer.accept(outcome[0]));
  }

  /** What went wrong; empty if nothing. */
  private String outcome(UrbiLobby by, Job job, Work work) {
    TagScope scope = job.enter(by.connectionTag().state());
    try {
      work.run(Frame.top(interpreter, job, by, new FrameLayout()));
      return "";
    } catch (UrbiException e) {
      e.unlessUncatchable();
      return Utf8Text.toJava(Diagnostics.place(e.span()) + text(by, job, e));
    } catch (ControlFlowException unwinding) {
      throw unwinding;
    } catch (StackOverflowError e) {
      return Problem.STACK_EXHAUSTED.text();
    } catch (OutOfMemoryError e) {
      return Problem.MEMORY_EXHAUSTED.text();
    } catch (RuntimeException | Error e) {
      FailureLog.internal("an intervention", e);
      return FailureLog.text(e);
    } finally {
      job.leave(scope);
    }
  }

  private String text(UrbiLobby by, Job job, UrbiException thrown) {
    try {
      return interpreter.asString(
          Frame.top(interpreter, job, by, new FrameLayout()), thrown.value());
    } catch (UrbiException e) {
      return Problem.UNPRINTABLE.text();
    }
  }
}
