package org.urbi.kernel.remote;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.uobject.ArgumentFailure;
import urbi.UValue;
import urbi.wire.Frame;
import urbi.wire.WireInput;

/** What the kernel has asked a remote process, and has no answer to yet. */
final class PendingCalls {
  /**
   * A question.
   *
   * @param number by which the answer names it
   */
  record Call(int number, CompletableFuture<UValue> result) {}

  private final RemoteTasks tasks;
  private final Map<Integer, CompletableFuture<UValue>> waiting = new HashMap<>();
  private int last;

  /**
   * @param tasks what the process has asked for
   */
  PendingCalls(RemoteTasks tasks) {
    this.tasks = tasks;
  }

  boolean isEmpty() {
    return waiting.isEmpty();
  }

  Call begin() {
    Call call = new Call(++last, new CompletableFuture<>());
    waiting.put(call.number(), call.result());
    return call;
  }

  /** Nobody waits for the answer any more. */
  void forget(Call call) {
    waiting.remove(call.number());
  }

  /** Completes the call that a frame of this type answers. */
  void answer(int type, WireInput in) {
    int call = in.size();
    switch (type) {
      case Frame.RESULT -> complete(call, in.value(), null);
      case Frame.ERROR -> complete(call, null, withoutTrace(new RuntimeException(in.text())));
      case Frame.ARGUMENT_ERROR -> complete(call, null, new ArgumentFailure(in.size(), in.text()));
      default -> complete(call, new UValue(), null);
    }
  }

  private void complete(int number, @Nullable UValue value, @Nullable RuntimeException error) {
    CompletableFuture<UValue> call = waiting.remove(number);
    if (call == null) {
      return;
    }
    // Requests that came before the result are finished first: the caller may rely on them, for
    // instance on functions bound by the call.
    tasks.whenFinished(
        error == null ? () -> call.complete(value) : () -> call.completeExceptionally(error));
  }

  /** There will be no answers: the process is lost. */
  void lose(String why) {
    List<CompletableFuture<UValue>> all = new ArrayList<>(waiting.values());
    waiting.clear();
    all.forEach(call -> call.completeExceptionally(lost(why)));
  }

  /** For who needs the process. */
  static RuntimeException lost(@Nullable String why) {
    return withoutTrace(new IllegalStateException(why));
  }

  /**
   * Where it is made says nothing: what was thrown in the process is in the log of that process.
   */
  private static RuntimeException withoutTrace(RuntimeException thrown) {
    thrown.setStackTrace(new StackTraceElement[0]);
    return thrown;
  }
}
