package org.urbi.kernel.uobject;

/**
 * The kernel does not do what a component asks for. If the component lets it pass, urbiscript gets
 * it as an error of the function that was called, and not as a failure of the component.
 */
final class KernelRefusal extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  KernelRefusal(String message) {
    super(message);
  }
}
