package org.urbi.kernel.observe;

import org.jspecify.annotations.Nullable;

/**
 * Who is told of variables and their values. Called on the kernel thread, which it must not keep:
 * what it does not take at once it leaves out.
 */
public interface VariableListener {
  /** Nobody. */
  VariableListener NONE =
      new VariableListener() {
        @Override
        public void appeared(int variable, String path, VariableKind kind) {}

        @Override
        public void gone(int variable) {}

        @Override
        public void value(int variable, long time, @Nullable Object value) {}

        @Override
        public void logged(long time, String line) {}

        @Override
        public void refused(String reason) {}
      };

  /**
   * There is a variable that has a value. One whose values become of another kind, or that gets a
   * better name, goes and appears again.
   *
   * @param variable its number, which no other one of this listener ever has
   * @param path its name
   */
  void appeared(int variable, String path, VariableKind kind);

  /** A variable is there no more. */
  void gone(int variable);

  /**
   * A variable that is followed has a value: the one that it had when that began, then each new
   * one.
   *
   * @param time of the kernel, in nanoseconds since the Epoch
   * @param value a Double, Boolean, String, {@link Bytes}, a List or Map of these; null for nil
   */
  void value(int variable, long time, @Nullable Object value);

  /**
   * The kernel has logged a line; may be called on any thread.
   *
   * @param time of the kernel, in nanoseconds since the Epoch
   */
  void logged(long time, String line);

  /** Something that was wanted is not told, for that reason. */
  void refused(String reason);
}
