package org.urbi.kernel.node;

import static java.util.Objects.requireNonNullElse;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** Call messages and unevaluated arguments (manual, "CallMessage" and "Lazy"). */
public final class CallMessages {
  private CallMessages() {}

  /** An argument that has not been evaluated yet. */
  public static final class Lazy extends UrbiObject {
    private final @Nullable Argument argument;

    /**
     * @param argument null in the prototype and in objects created by programs
     */
    public Lazy(Shape shape, @Nullable Argument argument) {
      super(shape);
      this.argument = argument;
    }

    /** The argument; null in the prototype and in objects created by programs. */
    public @Nullable Argument argument() {
      return argument;
    }

    @Override
    public UrbiObject cloned() {
      return new Lazy(cloneShape(), argument);
    }
  }

  /**
   * An argument as it was written.
   *
   * @param frame the activation of the caller
   * @param lobby the lobby with whose permissions it is evaluated
   */
  public record Argument(Node code, Frame frame, UrbiObject lobby) {
    /** Evaluates it in the activation of the caller, each time again. */
    public UrbiObject evaluate(Frame evaluator) {
      Job job = evaluator.job;
      return job.doFor(lobby, () -> code.execute(frame.in(job)));
    }
  }

  /** The call message of the function that runs in a frame. */
  static UrbiObject of(Frame frame) {
    Interpreter interpreter = frame.interpreter;
    var world = interpreter.world();
    UrbiObject message = interpreter.prototypes.callMessage.cloned();
    var arguments = new Elements(0);
    if (frame.site != null && frame.caller != null) {
      for (Node node : frame.site.argumentNodes()) {
        arguments.add(
            new Lazy(
                interpreter.prototypes.lazy.cloneShape(),
                new Argument(node, frame.caller, frame.job.lobby())));
      }
    }
    message.addSlot(world.symbol("target"), frame.self);
    message.addSlot(world.symbol("sender"), frame.caller == null ? frame.self : frame.caller.self);
    message.addSlot(
        world.symbol("code"), frame.function == null ? interpreter.values().nil : frame.function);
    message.addSlot(
        world.symbol("message"),
        interpreter.values().string(requireNonNullElse(frame.calledAs(), "")));
    message.addSlot(world.symbol("args"), interpreter.values().listOf(arguments));
    return message;
  }
}
