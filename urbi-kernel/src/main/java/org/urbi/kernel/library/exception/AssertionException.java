package org.urbi.kernel.library.exception;

import org.urbi.builtins.UrbiType;

/** A claim that does not hold (manual, "Exception"). */
@UrbiType(
    value = "Exception.Assertion",
    protos = {"Exception"},
    doc = "A claim that does not hold.")
final class AssertionException {
  private AssertionException() {}
}
