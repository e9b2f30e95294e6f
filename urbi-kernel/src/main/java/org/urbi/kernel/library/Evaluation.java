package org.urbi.kernel.library;

import org.urbi.kernel.compile.Compilation;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.Parsed;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.parse.UrbiParser;

/** Evaluates source text while code runs ({@code eval}, {@code load}). */
public final class Evaluation {
  private Evaluation() {}

  /**
   * Evaluates a whole text on a target.
   *
   * @param site where it is called; null when Java code does
   * @param file the name by which errors call it, or null
   * @return the value of its last statement
   */
  public static UrbiObject eval(
      Frame frame, CallSite site, UrbiObject target, String text, String file) {
    Parsed parsed = UrbiParser.parse(text, file);
    if (!parsed.errors().isEmpty()) {
      SyntaxError error = parsed.errors().getFirst();
      throw frame.interpreter().errors().syntax(error, text);
    }
    return execute(frame, site, target, parsed.sequence());
  }

  /** Executes statements one after the other, as the top level does. */
  private static UrbiObject execute(
      Frame frame, CallSite site, UrbiObject target, Ast.Sequence program) {
    UrbiObject value = frame.interpreter().values().voidObject;
    for (int i = 0; i < program.statements().size(); i++) {
      Compilation.Compiled compiled =
          Compilation.compile(frame.interpreter(), program.statements().get(i));
      Frame inner = frame.nested(site, target, compiled.layout());
      boolean background =
          i < program.separators().size() && program.separators().get(i) == Ast.Flavor.COMMA;
      if (background) {
        ControlType.start(inner, frame.job().scope(), compiled.code()::execute);
        frame.job().yield();
      } else {
        if (i > 0) {
          frame.job().yield();
        }
        value = compiled.code().execute(inner);
      }
    }
    return value;
  }
}
