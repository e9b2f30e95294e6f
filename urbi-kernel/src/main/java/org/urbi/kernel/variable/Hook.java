package org.urbi.kernel.variable;

import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** An action that runs when a variable is written, or before it is read. */
@FunctionalInterface
public interface Hook {
  /**
   * Runs the hook.
   *
   * @param frame the frame of the code that writes or reads
   * @param value the new value; before a read, the current one
   */
  void run(Frame frame, UrbiUVar variable, Datum value);

  /** Whether it also runs for its own reads and writes of the variable. */
  default boolean isReentrant() {
    return false;
  }

  /** Calls a function of urbiscript, whose target is the variable, for who installs the hook. */
  static Hook calling(Frame installer, UrbiObject function) {
    return new FunctionHook(installer.job().lobby(), function);
  }
}
