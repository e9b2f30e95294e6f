package org.urbi.kernel.uobject;

import org.urbi.kernel.error.Problem;

/**
 * The kernel refuses a request of a component. If the component does not catch it, it becomes an
 * urbiscript error of the called function, and does not count as a failure of the component.
 */
final class KernelRefusal extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  private final String reason;

  KernelRefusal(Problem problem, Object... places) {
    this(problem.text(places));
  }

  private KernelRefusal(String reason) {
    super(reason);
    this.reason = reason;
  }

  /** What is wrong. */
  String reason() {
    return reason;
  }
}
