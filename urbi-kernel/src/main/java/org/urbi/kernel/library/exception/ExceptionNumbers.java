package org.urbi.kernel.library.exception;

import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** Reads the numbers that exceptions hold. */
final class ExceptionNumbers {
  private ExceptionNumbers() {}

  /** The number in a slot, or a default when there is none. */
  static int count(UrbiObject exception, String slot, int otherwise) {
    UrbiObject value = exception.lookup(exception.world().symbol(slot));
    return value instanceof UrbiFloat number ? (int) number.value() : otherwise;
  }
}
