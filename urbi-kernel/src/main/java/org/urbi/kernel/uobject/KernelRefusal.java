package org.urbi.kernel.uobject;

import org.urbi.kernel.error.Problem;

/**
 * The kernel does not do what a component asks for. If the component lets it pass, urbiscript gets
 * it as an error of the function that was called, and not as a failure of the component.
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
