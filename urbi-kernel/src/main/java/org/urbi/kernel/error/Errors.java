package org.urbi.kernel.error;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.SlotNames;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;
import org.urbi.lang.parse.SyntaxError;

/**
 * Creates urbiscript exceptions for the {@linkplain Problem problems} of the catalogue (manual,
 * "Exception"). Each is an object cloned from the prototype of its type, so that programs can tell
 * them apart.
 */
public final class Errors {
  private final World world;
  private final Values values;
  private final SlotNames ofLookup;
  private final SlotNames ofRoutine;

  public Errors(World world) {
    this.world = world;
    this.values = world.values();
    Symbol message = world.symbol("message");
    ofLookup = new SlotNames(message, world.symbol("object"), world.symbol("name"));
    ofRoutine = new SlotNames(message, world.symbol("routine"));
  }

  /**
   * Whether the text of an exception includes where it was thrown, as it does once it has been
   * caught. A syntax error includes its location in the source.
   */
  public boolean tellsPlace(UrbiObject exception) {
    UrbiObject place = exception.localSlot(world.symbol("location"));
    return place != null && place != values.nil && !is(exception, ProblemKind.SYNTAX);
  }

  /** Whether an exception has the type of that kind of problem. */
  public boolean is(UrbiObject exception, ProblemKind kind) {
    String type = kind.type();
    UrbiObject prototype = type == null ? null : world.findPrototype(type);
    return prototype != null && exception.isA(prototype);
  }

  /** Creates the exception for a problem; the values fill the placeholders of its text. */
  public Builder of(Problem problem, Object... places) {
    return untold(problem).with("message", problem.text(places));
  }

  /** Creates an exception whose message is what its {@code asString} returns. */
  private Builder untold(Problem problem) {
    return untold(problem, problem.hint().orElse(null));
  }

  private Builder untold(Problem problem, @Nullable String hint) {
    String type = problem.kind().type();
    if (type == null) {
      throw new IllegalArgumentException(problem + " is no exception");
    }
    UrbiObject prototype = world.findPrototype(type);
    return new Builder(prototype == null ? values.object.cloned() : prototype.cloned(), hint);
  }

  /** Builds an exception. */
  public final class Builder {
    private final UrbiObject exception;
    private final @Nullable String hint;

    private Builder(UrbiObject exception, @Nullable String hint) {
      this.exception = exception;
      this.hint = hint;
    }

    /** Several slots of an exception that has none of them, at once. */
    private Builder with(SlotNames slots, UrbiObject... those) {
      slots.put(exception, those);
      return this;
    }

    public Builder with(String slot, UrbiObject value) {
      exception.addSlot(world.symbol(slot), value);
      return this;
    }

    public Builder with(String slot, String value) {
      return with(slot, values.string(value));
    }

    public Builder with(String slot, double value) {
      return with(slot, values.number(value));
    }

    public UrbiObject object() {
      return exception;
    }

    public UrbiException build() {
      return new UrbiException(exception, hint);
    }
  }

  /** {@code lookup failed: name}; for void, the error of an unexpected void. */
  public UrbiException lookup(UrbiObject target, String name) {
    if (target == values.voidObject) {
      return unexpectedVoid();
    }
    String text = Problem.NOT_FOUND.text(name);
    return untold(Problem.NOT_FOUND)
        .with(ofLookup, values.string(text), target, values.string(name))
        .build();
  }

  /** {@code unexpected void}. */
  public UrbiException unexpectedVoid() {
    return of(Problem.VOID).build();
  }

  /** {@code cannot modify const slot}. */
  public UrbiException constness() {
    return of(Problem.CONSTANT).build();
  }

  /** {@code slot redefinition: name}. */
  public UrbiException redefinition(String name) {
    return of(Problem.REDEFINED, name).with("name", name).build();
  }

  /** {@code pattern did not match}. */
  public UrbiException matchFailure() {
    return of(Problem.UNMATCHED).build();
  }

  /** {@code routine: problem}. */
  public UrbiException primitive(String routine, Problem problem, Object... places) {
    String text = problem.text(places);
    return untold(problem).with(ofRoutine, values.string(text), values.string(routine)).build();
  }

  /** {@code property lookup failed: slot->property}. */
  public UrbiException property(UrbiObject target, String slot, String property) {
    return of(Problem.PROPERTY_NOT_FOUND, slot + "->" + property)
        .with("object", target)
        .with("name", slot + "->" + property)
        .build();
  }

  /** {@code 1.5: syntax error: message}. */
  public UrbiException syntax(SyntaxError error, String input) {
    UrbiObject exception =
        untold(Problem.SYNTAX_ERROR)
            .with("message", error.reason())
            .with("loc", error.span().location().toString())
            .with("input", input)
            .object();
    return new UrbiException(exception, error);
  }

  /** A problem with jobs. */
  public UrbiException scheduling(Problem problem, Object... places) {
    return of(problem, places).build();
  }

  /** Ends a job that has exceeded a limit; it cannot be caught. */
  public UrbiException limit(Problem problem, Object... places) {
    return scheduling(problem, places).uncatchable();
  }

  /**
   * {@code routine: expected 2 arguments, given 1}, {@code expected at least …}, {@code expected
   * between … and …}.
   *
   * @param max {@link Integer#MAX_VALUE} when there may be any number
   */
  public UrbiException arity(String routine, int given, int min, int max) {
    return untold(arityProblem(min, max))
        .with("message", arityText(routine, given, min, max))
        .with("routine", routine)
        .with("effective", given)
        .with("minimum", min)
        .with("maximum", max == Integer.MAX_VALUE ? values.voidObject : values.number(max))
        .build();
  }

  private static Problem arityProblem(int min, int max) {
    if (max == min) {
      return Problem.ARGUMENTS_EXACTLY;
    }
    return max == Integer.MAX_VALUE ? Problem.ARGUMENTS_AT_LEAST : Problem.ARGUMENTS_BETWEEN;
  }

  /** The text of an arity error. */
  public static String arityText(String routine, int given, int min, int max) {
    return max == min
        ? Problem.ARGUMENTS_EXACTLY.text(routine, min, plural(min), given)
        : max == Integer.MAX_VALUE
            ? Problem.ARGUMENTS_AT_LEAST.text(routine, min, plural(min), given)
            : Problem.ARGUMENTS_BETWEEN.text(routine, min, max, plural(max), given);
  }

  /** {@code a} or {@code an}, as it stands before the name of a type. */
  public static String article(String type) {
    return !type.isEmpty() && "AEIOUaeiou".indexOf(type.charAt(0)) >= 0 ? "an" : "a";
  }

  private static String plural(int count) {
    return count < 2 ? "" : "s";
  }

  /** {@code routine: cannot inherit from a Finalizable without being one}. */
  public UrbiException finalizable(String routine) {
    return primitive(routine, Problem.NOT_INHERITABLE_FINALIZABLE);
  }

  /** {@code routine: argument 1: unexpected "x", expected a Float}; 0 is the target. */
  public UrbiException argumentType(
      String routine, int index, UrbiObject effective, UrbiObject expected) {
    return argument(routine, index, type(effective, expected).value());
  }

  /** {@code unexpected "x", expected a Float}. */
  public UrbiException type(UrbiObject effective, UrbiObject expected) {
    return untold(Problem.WRONG_TYPE)
        .with("effective", effective)
        .with("expected", expected)
        .build();
  }

  /**
   * {@code routine: argument 1: expected integer, got 0.5}; about the target, {@code routine:
   * expected integer, got 0.5}.
   */
  public UrbiException argumentNumber(
      String routine, int index, Problem problem, UrbiObject effective) {
    if (index == 0) {
      return badNumber(routine, problem, effective);
    }
    UrbiObject cause =
        untold(problem).with("fmt", problem.text("%s")).with("effective", effective).object();
    return argument(routine, index, cause);
  }

  /**
   * {@code routine: argument 1: …}, with the message of another exception.
   *
   * @param cause the error in the argument
   */
  public UrbiException argument(String routine, int index, UrbiObject cause) {
    return untold(index == 0 ? Problem.WRONG_TARGET : Problem.WRONG_ARGUMENT)
        .with("routine", routine)
        .with("index", index)
        .with("exception", cause)
        .build();
  }

  /** {@code routine: expected integer, got 0.5}. */
  public UrbiException badNumber(String routine, Problem problem, UrbiObject effective) {
    return badNumber(routine, problem, effective, "%s");
  }

  /**
   * The error of a number that a routine cannot use, with a text for the number.
   *
   * @param shown the text of the number
   */
  public UrbiException badNumber(
      String routine, Problem problem, UrbiObject effective, String shown) {
    String format = problem.text(shown);
    return untold(problem)
        .with("message", format)
        .with("routine", routine)
        .with("fmt", format)
        .with("effective", effective)
        .build();
  }
}
