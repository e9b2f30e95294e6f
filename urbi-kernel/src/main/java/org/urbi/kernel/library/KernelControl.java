package org.urbi.kernel.library;

import java.nio.file.Path;
import java.util.List;
import org.urbi.kernel.node.Frame;

/** What the library needs of the kernel around it. */
public interface KernelControl {
  /** Ends the kernel after this tick, with that exit status. */
  void requestShutdown(int status);

  /** Where source files are looked for, first to last. */
  List<Path> searchPath();

  /** The kernel in which code runs. */
  static KernelControl of(Frame frame) {
    return (KernelControl) frame.interpreter().host();
  }
}
