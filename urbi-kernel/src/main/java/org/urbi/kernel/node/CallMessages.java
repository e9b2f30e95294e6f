package org.urbi.kernel.node;

import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** Call messages and unevaluated arguments (manual, "CallMessage" and "Lazy"). */
public final class CallMessages {
  private CallMessages() {}

  /** An argument that has not been evaluated yet. */
  public static final class Lazy extends UrbiObject {
    private final Node code;
    private final Frame frame;
    private final UrbiObject lobby;

    /**
     * @param lobby for which it is evaluated if its evaluator may do something else
     */
    public Lazy(Shape shape, Node code, Frame frame, UrbiObject lobby) {
      super(shape);
      this.code = code;
      this.frame = frame;
      this.lobby = lobby;
    }

    /** The code; null in the prototype and in those made by hand. */
    public Node code() {
      return code;
    }

    /** Evaluates the argument in the activation of the caller; each time anew. */
    public UrbiObject evaluate(Frame evaluator) {
      Job job = evaluator.job;
      return job.doFor(lobby, () -> code.execute(frame.in(job)));
    }

    @Override
    public UrbiObject cloned() {
      return new Lazy(cloneShape(), code, frame, lobby);
    }
  }

  /** The call message of the function that runs in a frame. */
  static UrbiObject of(Frame frame) {
    Interpreter interpreter = frame.interpreter;
    var world = interpreter.world();
    UrbiObject message = interpreter.prototypes.callMessage.cloned();
    var arguments = new Elements(0);
    if (frame.site != null && frame.site.argumentNodes() != null) {
      for (Node node : frame.site.argumentNodes()) {
        arguments.add(
            new Lazy(
                interpreter.prototypes.lazy.cloneShape(), node, frame.caller, frame.job.lobby()));
      }
    }
    message.addSlot(world.symbol("target"), frame.self);
    message.addSlot(world.symbol("sender"), frame.caller == null ? frame.self : frame.caller.self);
    message.addSlot(
        world.symbol("code"), frame.function == null ? interpreter.values().nil : frame.function);
    message.addSlot(
        world.symbol("message"),
        interpreter.values().string(frame.calledAs() == null ? "" : frame.calledAs()));
    message.addSlot(world.symbol("args"), interpreter.values().listOf(arguments));
    return message;
  }
}
