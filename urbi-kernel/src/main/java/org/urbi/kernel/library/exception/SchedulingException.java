package org.urbi.kernel.library.exception;

import org.urbi.builtins.UrbiType;

/** Something went wrong with jobs (manual, "Exception"). */
@UrbiType(
    value = "Exception.Scheduling",
    protos = {"Exception"},
    doc = "Something went wrong with jobs.")
final class SchedulingException {
  private SchedulingException() {}
}
