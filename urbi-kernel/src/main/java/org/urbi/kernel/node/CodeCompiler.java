package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;

/** Compiles code that has run often to something that does the same, but faster. */
public interface CodeCompiler {
  /** Does nothing. */
  CodeCompiler NONE =
      new CodeCompiler() {
        @Override
        public int threshold() {
          return 0;
        }

        @Override
        public long turns() {
          return 0;
        }

        @Override
        public @Nullable CompiledCode function(
            Function.Body function, Node code, Frame frame, boolean last) {
          return null;
        }

        @Override
        public @Nullable CompiledCode loop(Node loop, Frame frame, boolean last) {
          return null;
        }

        @Override
        public Statistics statistics() {
          return new Statistics(0, 0, 0, 0, 0);
        }
      };

  /**
   * What was done so far.
   *
   * @param functions how many functions were compiled
   * @param loops how many loops were, besides those in compiled functions
   * @param counting how many of all loops, of those in compiled functions, too, count their {@code
   *     ;} themselves
   * @param refused how many were hot, but are not compiled
   * @param bytes how long the compiled code is
   */
  record Statistics(int functions, int loops, int counting, int refused, long bytes) {}

  /** After how many calls a function is to be compiled; 0 for never. */
  int threshold();

  /** After how many turns a loop is to be compiled; 0 for never. */
  long turns();

  /**
   * Compiles the body of a function.
   *
   * @param code its body
   * @param frame the activation that needs it
   * @param last whether it will not be compiled again, even if what it guesses turns out wrong
   * @return null if it is not worth it
   */
  @Nullable CompiledCode function(Function.Body function, Node code, Frame frame, boolean last);

  /**
   * Compiles the turns of a loop that is running.
   *
   * @param frame the activation in which it runs
   * @param last whether it will not be compiled again
   * @return null if it is not worth it
   */
  @Nullable CompiledCode loop(Node loop, Frame frame, boolean last);

  Statistics statistics();
}
