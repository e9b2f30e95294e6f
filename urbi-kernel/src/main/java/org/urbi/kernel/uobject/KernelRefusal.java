package org.urbi.kernel.uobject;

import org.urbi.kernel.error.Problem;

/**
 * The kernel does not do what a component asks for. If the component lets it pass, urbiscript gets
 * it as an error of the function that was called, and not as a failure of the component.
 */
final class KernelRefusal extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  KernelRefusal(Problem problem, Object... places) {
    super(problem.text(places));
  }
}
