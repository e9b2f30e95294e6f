package org.urbi.kernel.library.code;

import java.util.List;
import org.urbi.kernel.node.Frame;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.UrbiParser;
import org.urbi.lang.print.Printer;
import org.urbi.lang.source.Span;

/** The text of a piece of code, as the interpreter prints code. */
final class CodeText {
  private CodeText() {}

  /** The code written there; of a scope, what is in it. */
  static String of(Frame frame, Span span) {
    Ast.Sequence program =
        UrbiParser.parse(span.text(), null, frame.job()::checkInterrupted).sequence();
    List<Ast> statements = program.statements();
    return statements.size() == 1 && statements.getFirst() instanceof Ast.Scope scope
        ? Printer.printBody(scope)
        : Printer.printBody(new Ast.Scope(program.span(), program));
  }
}
