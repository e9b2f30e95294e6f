package org.urbi.kernel.job;

/** Leaves running code without being an error, so it has no Java stack trace. */
public abstract class ControlFlowException extends RuntimeException {
  protected ControlFlowException() {
    super(null, null, false, false);
  }
}
