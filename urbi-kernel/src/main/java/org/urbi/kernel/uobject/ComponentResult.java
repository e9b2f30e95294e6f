package org.urbi.kernel.uobject;

import java.util.concurrent.CompletionException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Outcome;
import urbi.UCast;
import urbi.UCastException;
import urbi.UValue;
import urbi.UVar;

/** What a thread of a component brings about for a job, as data. */
final class ComponentResult {
  private ComponentResult() {}

  /**
   * The outcome for a result or a failure.
   *
   * @param failure what was thrown, or null
   */
  static Outcome of(@Nullable Object result, @Nullable Throwable failure) {
    if (failure != null) {
      return new Outcome.Failure(failure);
    }
    try {
      return Outcome.value(
          switch (result) {
            case null -> null;
            case Boolean truth -> truth;
            case Number number -> number.doubleValue();
            case String text -> text;
            case UVar variable -> UValue.slotName(variable.getName());
            default -> UCast.toUValue(result);
          });
    } catch (UCastException e) {
      return new Outcome.Failure(new CompletionException(e));
    }
  }
}
