package org.urbi.kernel.library.system;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.compile.Compilation;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.library.code.Locations;
import org.urbi.kernel.library.concurrent.ControlType;
import org.urbi.kernel.library.lobby.Warnings;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Imports;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.ParseResult;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.parse.SyntaxWarning;
import org.urbi.lang.parse.UrbiParser;

/** Evaluates source text while code runs ({@code eval}, {@code load}). */
public final class Evaluation {
  private Evaluation() {}

  /**
   * Evaluates a whole text on a target.
   *
   * @param site the call that wants it evaluated; null when Java does
   * @param file the name by which errors call it, or null
   * @return the value of its last statement
   */
  public static UrbiObject eval(
      Frame frame, @Nullable CallSite site, UrbiObject target, String text, @Nullable String file) {
    return eval(frame, site, target, text, file, (inner, value) -> {});
  }

  /**
   * Evaluates a whole text on a target, and tells of each statement.
   *
   * @param seen is given the value of each statement, and the frame in which it was executed
   */
  public static UrbiObject eval(
      Frame frame,
      @Nullable CallSite site,
      UrbiObject target,
      String text,
      @Nullable String file,
      BiConsumer<Frame, UrbiObject> seen) {
    ParseResult parsed = UrbiParser.parse(text, file, frame.job()::checkInterrupted);
    for (SyntaxWarning warning : parsed.warnings()) {
      Warnings.in(frame, site, warning);
    }
    if (!parsed.errors().isEmpty()) {
      throw syntax(frame, site, parsed.errors().getFirst(), text);
    }
    return execute(frame, site, target, parsed.sequence(), seen);
  }

  /** The message has the location in the text, the backtrace shows the call that evaluated it. */
  private static UrbiException syntax(
      Frame frame, @Nullable CallSite site, SyntaxError error, String text) {
    UrbiException exception = frame.interpreter().errors().syntax(error, text);
    if (site == null) {
      return exception;
    }
    List<UrbiException.Call> calls = new ArrayList<>();
    calls.add(new UrbiException.Call(site.calledName(), site.calledSpan()));
    calls.addAll(frame.backtrace());
    exception.locate(null, calls);
    if (site.calledSpan() != null) {
      OwnSlots.put(
          exception.value(),
          "location",
          new Locations(frame.interpreter().world()).location(site.calledSpan()));
    }
    return exception;
  }

  /** Executes statements one after the other, as the top level does. */
  private static UrbiObject execute(
      Frame frame,
      @Nullable CallSite site,
      UrbiObject target,
      Ast.Sequence program,
      BiConsumer<Frame, UrbiObject> seen) {
    UrbiObject value = frame.interpreter().values().voidObject;
    Imports imports = new Imports();
    for (int i = 0; i < program.statements().size(); i++) {
      Compilation.Compiled compiled =
          Compilation.compile(frame.interpreter(), program.statements().get(i), imports);
      Frame inner = frame.nested(site, target, compiled.layout());
      boolean background =
          i < program.separators().size() && program.separators().get(i) == Ast.Flavor.COMMA;
      if (background) {
        ControlType.start(inner, frame.job().scopeForNew(), compiled.code()::execute);
        frame.job().yield();
      } else {
        if (i > 0) {
          frame.job().yield();
        }
        value = compiled.code().execute(inner);
        seen.accept(inner, value);
      }
    }
    return value;
  }
}
