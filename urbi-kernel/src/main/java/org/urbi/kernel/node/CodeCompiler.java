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
        public @Nullable CompiledCode function(Node code, int parameters, int locals) {
          return null;
        }

        @Override
        public @Nullable CompiledCode loop(Node loop, int locals) {
          return null;
        }

        @Override
        public Statistics statistics() {
          return new Statistics(0, 0, 0, 0);
        }
      };

  /**
   * What was done so far.
   *
   * @param functions how many functions were compiled
   * @param loops how many loops were, besides those in compiled functions
   * @param refused how many were hot, but are not compiled
   * @param bytes how long the compiled code is
   */
  record Statistics(int functions, int loops, int refused, long bytes) {}

  /**
   * After how many calls a function, and after how many turns a loop, is to be compiled; 0 for
   * never.
   */
  int threshold();

  /**
   * Compiles the body of a function.
   *
   * @param parameters how many of the variables have a value at its beginning
   * @param locals the number of plain variables in its frame
   * @return null if it is not worth it
   */
  @Nullable CompiledCode function(Node code, int parameters, int locals);

  /**
   * Compiles the turns of a loop that is running.
   *
   * @param locals the number of plain variables in its frame
   * @return null if it is not worth it
   */
  @Nullable CompiledCode loop(Node loop, int locals);

  Statistics statistics();
}
