package org.urbi.kernel.library.system;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.World;
import org.urbi.kernel.variable.Datum;
import org.urbi.kernel.variable.Hook;
import org.urbi.kernel.variable.UrbiUVar;
import org.urbi.lang.source.Span;

/**
 * {@code Global.evaluate}: source text that is written to it becomes its value (manual, "Global").
 */
public final class EvaluateVariable implements Hook {
  private static final CallSite ASSIGNMENT =
      new CallSite() {
        @Override
        public String calledName() {
          return "updateSlot";
        }

        @Override
        public @Nullable Span calledSpan() {
          return null;
        }
      };

  private EvaluateVariable() {}

  /** Makes the variable. */
  public static void install(Interpreter interpreter) {
    World world = interpreter.world();
    UrbiUVar variable = (UrbiUVar) world.prototype("UVar").cloned();
    variable.bind(
        interpreter, world.prototype("Global"), world.symbol("evaluate"), "Global", false);
    variable.notifyChangeOwned(new EvaluateVariable());
  }

  @Override
  public void run(Frame frame, UrbiUVar variable, Datum value) {
    if (value.value() instanceof UrbiString text) {
      UrbiObject result =
          Evaluation.eval(frame, ASSIGNMENT, frame.job().lobby(), text.value(), null);
      Datum datum = new Datum(result);
      variable.restore(datum, datum);
    }
  }

  /** The text may write to the variable, too. */
  @Override
  public boolean isReentrant() {
    return true;
  }
}
