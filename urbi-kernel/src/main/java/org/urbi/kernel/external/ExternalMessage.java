package org.urbi.kernel.external;

import java.util.List;
import urbi.UValue;

/** A message of a process in binary mode. */
sealed interface ExternalMessage {
  /** The process sets a variable. */
  record Assign(String variable, UValue value) implements ExternalMessage {}

  /** The process emits an event. */
  record Emit(String event, List<UValue> payload) implements ExternalMessage {}

  /** The result of a call. */
  record Reply(String call, UValue value) implements ExternalMessage {}

  /** Urbiscript, perhaps cut. */
  record Code(String text) implements ExternalMessage {}
}
