package org.urbi.kernel.job;

/** A way out of running code that is no error: it carries no Java stack trace. */
public abstract class Unwinding extends RuntimeException {
  protected Unwinding() {
    super(null, null, false, false);
  }
}
