package org.urbi.kernel.tier;

import java.lang.classfile.CodeBuilder;
import java.lang.constant.ClassDesc;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.node.Misses;
import org.urbi.kernel.object.Values;

/**
 * What is compiled at once: a function, or the turns of a loop.
 *
 * @param owner the class that is emitted
 * @param doubt makes it distrust what it knows, for tests; or null
 * @param misses counts how often it meets what it has not expected
 * @param counting how many of the loops that have been emitted count their {@code ;} themselves
 * @param slots how many slots the emitted code has taken
 * @param frame the activation that needs it
 * @param function null for a loop, whose variables are used afterwards
 * @param locals the number of plain variables
 * @param guarded whether somebody may look at the variables when an exception has left it
 * @param copiesLoops whether there is room for loops that are emitted twice
 */
record Unit(
    ClassDesc owner,
    Constants constants,
    Helpers helpers,
    Values values,
    @Nullable Doubt doubt,
    Misses misses,
    AtomicInteger counting,
    AtomicInteger slots,
    Survey survey,
    Frame frame,
    Function.@Nullable Body function,
    int locals,
    boolean guarded,
    boolean copiesLoops) {
  /** One of which nothing has been emitted. */
  Unit(
      ClassDesc owner,
      Values values,
      @Nullable Doubt doubt,
      Misses misses,
      Survey survey,
      Frame frame,
      Function.@Nullable Body function,
      int locals,
      boolean guarded,
      boolean copiesLoops) {
    this(
        owner,
        new Constants(),
        new Helpers(),
        values,
        doubt,
        misses,
        new AtomicInteger(),
        new AtomicInteger(),
        survey,
        frame,
        function,
        locals,
        guarded,
        copiesLoops);
  }

  /** Pushes an object of the kernel. */
  void constant(CodeBuilder code, Object value, ClassDesc type) {
    code.getstatic(constants.field(code.constantPool(), owner, value, type));
  }

  /** The same, as short as possible. */
  Unit withoutCopies() {
    return again(false);
  }

  /** The same, to be emitted again. */
  Unit again() {
    return again(copiesLoops);
  }

  private Unit again(boolean itCopiesLoops) {
    return new Unit(
        owner, values, doubt, misses, survey, frame, function, locals, guarded, itCopiesLoops);
  }

  boolean isLoop() {
    return function == null;
  }

  /** Whether closures or other jobs can reach variables of the function. */
  boolean hasCells() {
    return function != null && function.hasCells();
  }

  /** How many variables have a value at the beginning. */
  int known() {
    return function == null ? locals : function.parameters();
  }
}
