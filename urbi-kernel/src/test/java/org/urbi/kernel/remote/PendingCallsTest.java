package org.urbi.kernel.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.object.World;
import org.urbi.kernel.uobject.ArgumentFailure;
import urbi.UValue;
import urbi.wire.Frame;
import urbi.wire.WireException;
import urbi.wire.WireInput;
import urbi.wire.WireOutput;

/** Answers of a remote process, in whatever order, to what was asked and to what was not. */
class PendingCallsTest {
  private final World world = new World();

  /** Without a scheduler: the process asks for nothing. */
  @SuppressWarnings("NullAway") // Nothing is scheduled while there is no task.
  private final PendingCalls calls =
      new PendingCalls(
          new RemoteTasks(null, () -> world.values().object, size -> {}, failure -> {}));

  private final WireOutput out = new WireOutput(64);

  private void answer(int type) {
    byte[] bytes = out.toBytes();
    calls.answer(type, new WireInput(bytes, 0, bytes.length));
  }

  private static Throwable cause(PendingCalls.Call call) {
    return assertThrows(CompletionException.class, () -> call.result().join()).getCause();
  }

  @Test
  void answersFindTheirQuestions() {
    PendingCalls.Call first = calls.begin();
    PendingCalls.Call second = calls.begin();
    out.size(second.number()).value(new UValue(2));
    answer(Frame.RESULT);
    assertFalse(first.result().isDone());
    assertEquals(2, second.result().join().doubleValue());
    assertFalse(calls.isEmpty());
    calls.forget(first);
    assertTrue(calls.isEmpty());
  }

  @Test
  void failuresHaveNoTraceOfOurs() {
    PendingCalls.Call call = calls.begin();
    out.size(call.number()).text("no power");
    answer(Frame.ERROR);
    assertEquals("no power", cause(call).getMessage());
    assertEquals(0, cause(call).getStackTrace().length);
  }

  @Test
  void rejectedArgumentIsNamed() {
    PendingCalls.Call call = calls.begin();
    out.size(call.number()).size(2).text("Float");
    answer(Frame.ARGUMENT_ERROR);
    assertEquals("invalid argument 2, expected Float", cause(call).getMessage());
    assertEquals(ArgumentFailure.class, cause(call).getClass());
  }

  /** A process answers twice, late, and what nobody asked. */
  @Test
  void answersThatNobodyWaitsForAreDropped() {
    PendingCalls.Call call = calls.begin();
    out.size(call.number()).value(new UValue(1));
    answer(Frame.RESULT);
    answer(Frame.RESULT);
    assertEquals(1, call.result().join().doubleValue());
    PendingCalls.Call forgotten = calls.begin();
    calls.forget(forgotten);
    WireOutput late = new WireOutput(64).size(forgotten.number()).value(new UValue(1));
    byte[] bytes = late.toBytes();
    calls.answer(Frame.RESULT, new WireInput(bytes, 0, bytes.length));
    assertFalse(forgotten.result().isDone());
  }

  @Test
  void cutAnswerIsRefused() {
    PendingCalls.Call call = calls.begin();
    out.size(call.number());
    assertThrows(WireException.class, () -> answer(Frame.RESULT));
    assertFalse(call.result().isDone());
  }

  @Test
  void lostProcessAnswersNobody() {
    PendingCalls.Call first = calls.begin();
    PendingCalls.Call second = calls.begin();
    calls.lose("the remote process has gone");
    assertTrue(calls.isEmpty());
    assertEquals("the remote process has gone", cause(first).getMessage());
    assertEquals("the remote process has gone", cause(second).getMessage());
  }
}
