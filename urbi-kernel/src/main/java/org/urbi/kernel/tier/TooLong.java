package org.urbi.kernel.tier;

/** Code that the Java machine would not compile, or not even load, because of its length. */
final class TooLong extends RuntimeException {
  private static final long serialVersionUID = 1L;

  TooLong() {
    super(null, null, false, false);
  }
}
