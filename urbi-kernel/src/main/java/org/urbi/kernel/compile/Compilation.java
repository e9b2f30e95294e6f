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
import org.urbi.lang.ast.Declaring;
import org.urbi.lang.grammar.Checkpoint;
import org.urbi.lang.source.Span;

/**
 * Compiles a syntax tree to executable nodes: local names become indices in frames, and syntactic
 * sugar is removed.
 *
 * <p>A variable stands in the frame when only the job that declares it can reach it, and in a cell
 * when a closure or another job can. That is known only when the whole code has been seen; so the
 * code is compiled, and compiled again if a variable turned out to be shared.
 */
public final class Compilation {
  private final Interpreter interpreter;
  private final Imports imports;
  private final Checkpoint checkpoint;
  private final Set<Declaring> sharedKeys = Collections.newSetFromMap(new IdentityHashMap<>());
  private boolean learned;
  private int regions;
  final Statements statements;
  final Expressions expressions;
  final Assertions claims;
  final ImplicitReceivers receivers;
  final Functions functions;
  final EventHandlers handlers;
  final Definitions definitions;
  final Assignments assignments;

  private Compilation(Interpreter interpreter, Imports imports, Checkpoint checkpoint) {
    this.interpreter = interpreter;
    this.imports = imports;
    this.checkpoint = checkpoint;
    this.statements = new Statements(this);
    this.expressions = new Expressions(this);
    this.claims = new Assertions(this);
    this.receivers = new ImplicitReceivers(this);
    this.functions = new Functions(this);
    this.handlers = new EventHandlers(this);
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
   * @param imports the imports of earlier statements; this one may add to them
   */
  public static Compiled compile(Interpreter interpreter, Ast statement, Imports imports) {
    return compile(interpreter, statement, imports, interpreter::checkInterrupted);
  }

  /**
   * Compiles a statement of the top level.
   *
   * @param imports the imports of earlier statements; this one may add to them
   * @param checkpoint called again and again, to end the work by an exception
   */
  public static Compiled compile(
      Interpreter interpreter, Ast statement, Imports imports, Runnable checkpoint) {
    var compilation = new Compilation(interpreter, imports, new Checkpoint(checkpoint));
    while (true) {
      compilation.learned = false;
      compilation.regions = 0;
      CompilationUnit unit = new CompilationUnit();
      Node code = compilation.compile(statement, LexicalScope.top(unit), HandledJumps.ALL);
      if (!compilation.learned) {
        code.standsIn();
        return new Compiled(code, unit.layout());
      }
    }
  }

  /**
   * Compiles a tree.
   *
   * @param seen which jumps the surrounding statements check for when this one has ended, so that
   *     {@code return} and {@code break} need not be thrown as exceptions
   */
  Node compile(Ast ast, LexicalScope block, HandledJumps seen) {
    checkpoint.pass();
    return ast.accept(new TranslationVisitor(this, block, seen));
  }

  /** Compiles an expression whose value is used. */
  Node operand(Ast ast, LexicalScope block) {
    return compile(ast, block, HandledJumps.NOTHING);
  }

  /** Like {@link #operand}, but for an optional expression: null if there is none. */
  @Nullable Node optional(@Nullable Ast ast, LexicalScope block) {
    return ast == null ? null : operand(ast, block);
  }

  Node[] all(List<Ast> asts, LexicalScope block) {
    Node[] nodes = new Node[asts.size()];
    for (int i = 0; i < nodes.length; i++) {
      nodes[i] = operand(asts.get(i), block);
    }
    return nodes;
  }

  /** The imports of the top level. */
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
  LocalVariable declare(LexicalScope block, String name, Declaring key) {
    boolean shared = sharedKeys.contains(key);
    FrameLayout layout = block.unit().layout();
    int index = shared ? layout.addCell() : layout.addLocal();
    LocalVariable variable = new LocalVariable(block.unit(), block.region(), key, shared, index);
    block.add(name, variable);
    return variable;
  }

  /**
   * Whether the variable of a declaration must be kept in a cell, because a closure or another job
   * uses it.
   */
  boolean isShared(Declaring key) {
    return sharedKeys.contains(key);
  }

  /** Where code of a block finds a variable. */
  Variables.Place place(LocalVariable variable, LexicalScope block) {
    return place(variable, block, false);
  }

  /**
   * Where a block finds the variable that it declares, if a surrounding block has created it
   * already.
   */
  Variables.Place placeBegun(LocalVariable variable, LexicalScope block) {
    return place(variable, block, true);
  }

  private Variables.Place place(LocalVariable variable, LexicalScope block, boolean begun) {
    boolean constant =
        variable.key() instanceof Ast.Declaration declaration && declaration.constant();
    return new Variables.Place(indexFrom(variable, block), variable.shared(), begun, constant);
  }

  /** Reads a variable from a block. */
  Node read(Span span, LocalVariable variable, LexicalScope block) {
    int index = indexFrom(variable, block);
    return variable.shared() ? new Variables.Shared(span, index) : new Variables.Local(span, index);
  }

  private int indexFrom(LocalVariable variable, LexicalScope block) {
    boolean elsewhere = variable.unit() != block.unit() || variable.region() != block.region();
    if (elsewhere && !variable.shared()) {
      sharedKeys.add(variable.key());
      learned = true;
    }
    return variable.shared() ? block.unit().cellOf(variable) : variable.index();
  }
}
