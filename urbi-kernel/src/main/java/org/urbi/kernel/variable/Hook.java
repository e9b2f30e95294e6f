package org.urbi.kernel.variable;

import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** Something that is done when a variable is written, or before it is read. */
@FunctionalInterface
public interface Hook {
  /**
   * Does it.
   *
   * @param frame the code that writes or reads
   * @param value the new value; before a read, the present one
   */
  void run(Frame frame, UrbiUVar variable, Datum value);

  /** Whether it runs even for what it does itself to the variable. */
  default boolean isReentrant() {
    return false;
  }

  /** Calls a function of urbiscript, whose target is the variable. */
  static Hook calling(UrbiObject function) {
    return (frame, variable, value) -> frame.interpreter().call(frame, function, variable);
  }
}
