package org.urbi.kernel.node;

import static java.util.Objects.requireNonNullElse;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.SlotNames;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Call messages and unevaluated arguments (manual, "CallMessage" and "Lazy"). */
public final class CallMessages {
  private final SlotNames slots;
  private final SlotLookup args;
  private final SlotLookup eval;

  CallMessages(World world) {
    Symbol arguments = world.symbol("args");
    slots =
        new SlotNames(
            world.symbol("target"),
            world.symbol("sender"),
            world.symbol("code"),
            world.symbol("message"),
            arguments);
    args = new SlotLookup(world, arguments);
    eval = new SlotLookup(world, world.symbol("eval"));
  }

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
      return job.identity().doFor(lobby, () -> code.execute(frame.in(job)));
    }
  }

  /** The call message of the function that runs in a frame. */
  UrbiObject of(Frame frame) {
    Interpreter interpreter = frame.interpreter;
    var arguments = new Elements(0);
    if (frame.site != null && frame.caller != null) {
      for (Node node : frame.site.argumentNodes()) {
        Lazy lazy =
            new Lazy(
                interpreter.prototypes.lazy.cloneShape(),
                new Argument(node, frame.caller, frame.job.lobby()));
        PermissionCheck.claimForObserver(frame, lazy);
        arguments.add(lazy);
      }
    }
    return interpreter.prototypes.callMessage.clonedWith(
        slots,
        frame.self,
        frame.caller == null ? frame.self : frame.caller.self,
        frame.function == null ? interpreter.values().nil : frame.function,
        interpreter.values().string(requireNonNullElse(frame.calledAs(), "")),
        interpreter.values().listOf(arguments));
  }

  /** The arguments of a call message; none if somebody has replaced their list. */
  public List<UrbiObject> arguments(Frame frame, UrbiObject message) {
    UrbiObject found = args.find(frame, message);
    if (found == null) {
      throw frame.interpreter.errors().lookup(message, args.name().name());
    }
    return found instanceof UrbiList list ? list.elements() : List.of();
  }

  /** The value of an argument, each time anew. */
  public UrbiObject evaluate(Frame frame, UrbiObject argument) {
    return frame.interpreter.send(frame, argument, eval);
  }
}
