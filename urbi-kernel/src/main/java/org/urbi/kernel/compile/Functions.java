package org.urbi.kernel.compile;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CallMessageNode;
import org.urbi.kernel.node.Formals;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Node;
import org.urbi.lang.ast.Ast;

/** Compiles functions and closures. */
final class Functions {
  /** The variable of the call message. It is not a valid identifier, so no program can use it. */
  static final String CALL = "<call>";

  private final Compilation compilation;

  Functions(Compilation compilation) {
    this.compilation = compilation;
  }

  Node compile(Ast.Function function, LexicalScope block) {
    CompilationUnit unit = new CompilationUnit(block.unit());
    // In a closure, "call" is the one of the surrounding function, as is "this".
    unit.callKey = function.closure() ? null : function.body();
    unit.closure = function.closure();
    LexicalScope parameters = block.function(unit, compilation.newRegion());
    Formals formals = null;
    int[] cells = null;
    if (function.formals() != null) {
      cells = declare(function.formals(), parameters, unit);
      formals = formals(function.formals(), parameters, cells);
    }
    // The body gets a scope of its own: its variables may hide the parameters.
    Node code =
        compilation.statements.body(
            function.body(), parameters.construct().scope(), HandledJumps.ALL);
    LocalVariable call = parameters.local(CALL);
    if (call != null) {
      code = new CallMessageNode.Declared(code, compilation.place(call, parameters));
    }
    var body =
        new Function.Body(
            function,
            code,
            unit.layout(),
            formals,
            allPlain(cells) ? null : cells,
            unit.usesCall || formals == null,
            unit.closure && unit.returns);
    return new Literals.Closure(function.span(), body, unit.capturedFrom(), function.closure());
  }

  /**
   * Gives each parameter its index among the locals, in order; then gives the shared ones a cell.
   */
  private int[] declare(List<Ast.Formal> formals, LexicalScope block, CompilationUnit unit) {
    for (int i = 0; i < formals.size(); i++) {
      unit.layout().addLocal();
    }
    int[] cells = new int[formals.size()];
    for (int i = 0; i < cells.length; i++) {
      Ast.Formal formal = formals.get(i);
      boolean shared = compilation.isShared(formal);
      cells[i] = shared ? unit.layout().addCell() : -1;
      block.add(
          formal.name(),
          new LocalVariable(unit, block.region(), formal, shared, shared ? cells[i] : i));
    }
    return cells;
  }

  private Formals formals(List<Ast.Formal> formals, LexicalScope block, int[] cells) {
    int count = formals.size();
    String[] names = new String[count];
    Node[] defaults = new Node[count];
    Node[] types = new Node[count];
    for (int i = 0; i < count; i++) {
      Ast.Formal formal = formals.get(i);
      names[i] = formal.name();
      defaults[i] = compilation.optional(formal.defaultValue(), block);
      types[i] = compilation.optional(formal.type(), block);
    }
    boolean variadic = count > 0 && formals.getLast().variadic();
    return new Formals(names, defaults, types, cells, variadic);
  }

  private static boolean allPlain(int @Nullable [] cells) {
    if (cells != null) {
      for (int cell : cells) {
        if (cell >= 0) {
          return false;
        }
      }
    }
    return true;
  }
}
