package org.urbi.kernel.error;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;
import org.urbi.lang.parse.SyntaxError;

/**
 * Every error that the language itself reports, with the text of the manual ("Exception"). Each is
 * an object cloned from the prototype of its type, so that programs can tell them apart.
 */
public final class Errors {
  private final World world;
  private final Values values;
  private final Map<String, UrbiObject> prototypes = new LinkedHashMap<>();

  public Errors(World world) {
    this.world = world;
    this.values = world.values();
  }

  /** Declares the prototype of a type of exceptions, such as "Arity". */
  public void declare(String type, UrbiObject prototype) {
    prototypes.put(type, prototype);
  }

  /** The prototype of a type of exceptions. */
  public @Nullable UrbiObject prototype(String type) {
    return prototypes.get(type);
  }

  /**
   * Whether the text of an exception tells where it was thrown: it does once it has been caught. An
   * error of syntax tells its place in the source.
   */
  public boolean tellsPlace(UrbiObject exception) {
    UrbiObject syntax = prototypes.get("Syntax");
    return exception.localSlot(world.symbol("location")) != null
        && !(syntax != null && exception.isA(syntax));
  }

  /** An exception of that type, with that message. */
  public Builder of(String type, @Nullable String message) {
    return of(type).with("message", values.string(message));
  }

  /** An exception of that type; who catches it finds as its message what its asString says. */
  private Builder of(String type) {
    UrbiObject prototype = prototypes.get(type);
    return new Builder(prototype == null ? values.object.cloned() : prototype.cloned());
  }

  /** An exception being filled. */
  public final class Builder {
    private final UrbiObject exception;

    private Builder(UrbiObject exception) {
      this.exception = exception;
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
      return new UrbiException(exception);
    }
  }

  /** {@code lookup failed: name}; void has nothing to look for. */
  public UrbiException lookup(UrbiObject target, String name) {
    if (target == values.voidObject) {
      return unexpectedVoid();
    }
    return of("Lookup", "lookup failed: " + name).with("object", target).with("name", name).build();
  }

  /** {@code unexpected void}. */
  public UrbiException unexpectedVoid() {
    return of("UnexpectedVoid", "unexpected void").build();
  }

  /** {@code cannot modify const slot}. */
  public UrbiException constness() {
    return of("Constness", "cannot modify const slot").build();
  }

  /** {@code slot redefinition: name}. */
  public UrbiException redefinition(String name) {
    return of("Redefinition", "slot redefinition: " + name).with("name", name).build();
  }

  /** {@code pattern did not match}. */
  public UrbiException matchFailure() {
    return of("MatchFailure", "pattern did not match").build();
  }

  /** {@code routine: message}. */
  public UrbiException primitive(String routine, @Nullable String message) {
    return of("Primitive", message).with("routine", named(routine)).build();
  }

  /** Code that is called from Java, as when a variable changes, may be called by no name. */
  private static String named(String routine) {
    return routine == null ? "apply" : routine;
  }

  /** {@code property lookup failed: slot->property}. */
  public UrbiException property(UrbiObject target, String slot, String property) {
    return of("PropertyLookup", "property lookup failed: " + slot + "->" + property)
        .with("object", target)
        .with("name", slot + "->" + property)
        .build();
  }

  /** {@code 1.5: syntax error: message}. */
  public UrbiException syntax(SyntaxError error, String input) {
    return of("Syntax", error.message().replaceFirst("^syntax error: ", ""))
        .with("loc", error.span().location().toString())
        .with("input", input)
        .build();
  }

  public UrbiException scheduling(String message) {
    return of("Scheduling", message).build();
  }

  /** Ends a job that has gone beyond what is allowed; it cannot be caught. */
  public UrbiException limit(String message) {
    return scheduling(message).uncatchable();
  }

  /**
   * {@code routine: expected 2 arguments, given 1}, {@code expected at least …}, {@code expected
   * between … and …}.
   *
   * @param max {@link Integer#MAX_VALUE} when there may be any number
   */
  public UrbiException arity(String routine, int given, int min, int max) {
    String name = named(routine);
    return of("Arity", arityMessage(name, given, min, max))
        .with("routine", name)
        .with("effective", given)
        .with("minimum", min)
        .with("maximum", max == Integer.MAX_VALUE ? values.voidObject : values.number(max))
        .build();
  }

  /** {@code routine: cannot inherit from a Finalizable without being one}. */
  public UrbiException finalizable(String routine) {
    return primitive(routine, "cannot inherit from a Finalizable without being one");
  }

  /** The text of an arity error. */
  public static String arityMessage(String routine, int given, int min, int max) {
    String expected;
    if (max == min) {
      expected = min + (min < 2 ? " argument" : " arguments");
    } else if (max == Integer.MAX_VALUE) {
      expected = "at least " + min + (min < 2 ? " argument" : " arguments");
    } else {
      expected = "between " + min + " and " + max + (max < 2 ? " argument" : " arguments");
    }
    return routine + ": expected " + expected + ", given " + given;
  }

  /** {@code routine: argument 1: unexpected "x", expected a Float}; 0 is the target. */
  public UrbiException argumentType(
      String routine, int index, UrbiObject effective, UrbiObject expected) {
    return argument(routine, index, type(effective, expected).value());
  }

  /** {@code unexpected "x", expected a Float}. */
  public UrbiException type(UrbiObject effective, UrbiObject expected) {
    return of("Type").with("effective", effective).with("expected", expected).build();
  }

  /**
   * {@code routine: argument 1: expected integer, got 0.5}; about the target, {@code routine:
   * expected integer, got 0.5}.
   *
   * @param type such as "BadInteger"
   * @param message what precedes the number
   */
  public UrbiException argumentNumber(
      String type, String routine, int index, String message, UrbiObject effective) {
    if (index == 0) {
      return badNumber(type, routine, message + "%s", effective);
    }
    UrbiObject cause = of(type).with("fmt", message + "%s").with("effective", effective).object();
    return argument(routine, index, cause);
  }

  /**
   * {@code routine: argument 1: …}, with the message of another exception.
   *
   * @param cause what was wrong with the argument
   */
  public UrbiException argument(String routine, int index, UrbiObject cause) {
    return of("Argument")
        .with("routine", named(routine))
        .with("index", index)
        .with("exception", cause)
        .build();
  }

  /** {@code routine: message} about a number. */
  public UrbiException badNumber(
      String type, String routine, String message, UrbiObject effective) {
    return of(type, message)
        .with("routine", named(routine))
        .with("fmt", message)
        .with("effective", effective)
        .build();
  }
}
