package org.urbi.kernel.library.exception;

import org.urbi.builtins.UrbiType;

/** What a {@code Timeout} throws when the time is over (manual, "Timeout"). */
@UrbiType(
    value = "Exception.TimeOut",
    protos = {"Exception"},
    doc = "Code that has taken too much time.")
final class TimeOutException {
  private TimeOutException() {}
}
