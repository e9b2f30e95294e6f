package org.urbi.kernel.job;

/** A way out of running code that is no error: it carries no Java stack trace. */
public abstract class ControlFlowException extends RuntimeException {
  protected ControlFlowException() {
    super(null, null, false, false);
  }
}
