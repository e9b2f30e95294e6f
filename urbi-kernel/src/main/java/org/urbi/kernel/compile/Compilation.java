package org.urbi.kernel.compile;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Imports;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Variables;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.source.Span;

/**
 * Compiles a tree to executable nodes: local names become places in frames, sugar goes.
 *
 * <p>A variable stands in the frame when only the job that declares it can reach it, and in a cell
 * when a closure or another job can. That is known only when the whole code has been seen; so the
 * code is compiled, and compiled again if a variable turned out to be shared.
 */
public final class Compilation {
  private final Interpreter interpreter;
  private final Imports imports;
  private final Set<Object> sharedKeys = Collections.newSetFromMap(new IdentityHashMap<>());
  private boolean learned;
  private int regions;
  final Statements statements;
  final Expressions expressions;
  final Claims claims;
  final Receivers receivers;
  final Functions functions;
  final Handlers handlers;
  final Definitions definitions;
  final Assignments assignments;

  private Compilation(Interpreter interpreter, Imports imports) {
    this.interpreter = interpreter;
    this.imports = imports;
    this.statements = new Statements(this);
    this.expressions = new Expressions(this);
    this.claims = new Claims(this);
    this.receivers = new Receivers(this);
    this.functions = new Functions(this);
    this.handlers = new Handlers(this);
    this.definitions = new Definitions(this);
    this.assignments = new Assignments(this);
  }

  /** Compiled code of the top level. */
  public record Compiled(Node code, FrameLayout layout) {}

  /** Compiles a statement that stands alone. */
  public static Compiled compile(Interpreter interpreter, Ast statement) {
    return compile(interpreter, statement, new Imports());
  }

  /**
   * Compiles a statement of the top level.
   *
   * @param imports what the statements before have imported; this one may add to it
   */
  public static Compiled compile(Interpreter interpreter, Ast statement, Imports imports) {
    var compilation = new Compilation(interpreter, imports);
    while (true) {
      compilation.learned = false;
      compilation.regions = 0;
      Unit unit = new Unit();
      Node code = compilation.compile(statement, Block.top(unit), Seen.ALL);
      if (!compilation.learned) {
        return new Compiled(code, unit.layout());
      }
    }
  }

  /**
   * Compiles a tree.
   *
   * @param seen whether the statements around look at how this one ended, so that {@code return}
   *     and {@code break} need not be thrown
   */
  Node compile(Ast ast, Block block, Seen seen) {
    interpreter.checkInterrupted();
    return ast.accept(new Translation(this, block, seen));
  }

  /** Compiles what is asked for its value. */
  Node operand(Ast ast, Block block) {
    return compile(ast, block, Seen.NOTHING);
  }

  /** Like {@link #operand}, of what may be absent; null when it is. */
  @Nullable Node optional(@Nullable Ast ast, Block block) {
    return ast == null ? null : operand(ast, block);
  }

  Node[] all(List<Ast> asts, Block block) {
    return asts.stream().map(ast -> operand(ast, block)).toArray(Node[]::new);
  }

  /** What is imported at the top level. */
  Imports imports() {
    return imports;
  }

  Interpreter interpreter() {
    return interpreter;
  }

  int newRegion() {
    return ++regions;
  }

  /** Declares a variable in a block. */
  Variable declare(Block block, String name, Object key) {
    boolean shared = sharedKeys.contains(key);
    FrameLayout layout = block.unit().layout();
    int index = shared ? layout.addCell() : layout.addLocal();
    Variable variable = new Variable(block.unit(), block.region(), key, shared, index);
    block.add(name, variable);
    return variable;
  }

  /** Whether a declaration has turned out to be shared. */
  boolean isShared(Object key) {
    return sharedKeys.contains(key);
  }

  /** Where a variable is, seen from a block. */
  Variables.Place place(Variable variable, Block block) {
    return place(variable, block, false);
  }

  /** Where a variable is that has been begun elsewhere, seen from the block that declares it. */
  Variables.Place placeBegun(Variable variable, Block block) {
    return place(variable, block, true);
  }

  private Variables.Place place(Variable variable, Block block, boolean begun) {
    boolean constant =
        variable.key() instanceof Ast.Declaration declaration && declaration.constant();
    return new Variables.Place(indexFrom(variable, block), variable.shared(), begun, constant);
  }

  /** Reads a variable from a block. */
  Node read(Span span, Variable variable, Block block) {
    int index = indexFrom(variable, block);
    return variable.shared() ? new Variables.Shared(span, index) : new Variables.Local(span, index);
  }

  private int indexFrom(Variable variable, Block block) {
    boolean elsewhere = variable.unit() != block.unit() || variable.region() != block.region();
    if (elsewhere && !variable.shared()) {
      sharedKeys.add(variable.key());
      learned = true;
    }
    return variable.shared() ? block.unit().cellOf(variable) : variable.index();
  }
}
