package org.urbi.kernel.compile;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Assertion;
import org.urbi.kernel.node.Conditionals;
import org.urbi.kernel.node.ForEach;
import org.urbi.kernel.node.Loops;
import org.urbi.kernel.node.Matching;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.ScopeEnd;
import org.urbi.kernel.node.Sequences;
import org.urbi.kernel.node.Try;
import org.urbi.kernel.node.Variables;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.Ast.Flavor;
import org.urbi.lang.ast.LocalNames;
import org.urbi.lang.source.Span;

/** Compiles statements. */
final class Statements {
  private final Compilation compilation;

  Statements(Compilation compilation) {
    this.compilation = compilation;
  }

  private Node compile(Ast ast, LexicalScope block, HandledJumps seen) {
    return compilation.compile(ast, block, seen);
  }

  /** Code for another job, with variables of its own. */
  Node job(Ast ast, LexicalScope block) {
    return compile(ast, block.job(compilation.newRegion()), HandledJumps.ALL);
  }

  // ------------------------------------------------------------------ composition

  Node sequence(Ast.Sequence sequence, LexicalScope block, HandledJumps seen) {
    return sequence(sequence, block, seen, UnaryOperator.identity());
  }

  /**
   * @param around wraps the compiled statements, but not the wait for the background statements
   */
  private Node sequence(
      Ast.Sequence sequence, LexicalScope block, HandledJumps seen, UnaryOperator<Node> around) {
    List<Node> statements = new ArrayList<>();
    List<Boolean> yields = new ArrayList<>();
    if (sequence.separators().contains(Flavor.AND)) {
      Node[] branches =
          sequence.statements().stream()
              .map(ast -> branch(ast, block, statements, yields))
              .toArray(Node[]::new);
      statements.add(new Sequences.Parallel(sequence.span(), branches));
      yields.add(false);
      return around.apply(chain(sequence, statements, yields));
    }
    boolean background = false;
    for (int i = 0; i < sequence.statements().size(); i++) {
      Ast ast = sequence.statements().get(i);
      Flavor after = i < sequence.separators().size() ? sequence.separators().get(i) : null;
      if (ast instanceof Ast.Noop && after != null) {
        continue;
      }
      if (after == Flavor.COMMA) {
        background = true;
        Node code = branch(ast, block, statements, yields);
        statements.add(new Sequences.Spawn(ast.span(), code));
        yields.add(false);
      } else {
        statements.add(compile(ast, block, seen));
        yields.add(after == Flavor.SEMICOLON);
      }
    }
    Node code = around.apply(chain(sequence, statements, yields));
    return background ? new Sequences.WithBackground(sequence.span(), code) : code;
  }

  /**
   * A statement that runs in a job of its own. Its declarations belong to the surrounding scope, so
   * the variables are created there before the job starts.
   */
  private Node branch(Ast ast, LexicalScope block, List<Node> before, List<Boolean> yields) {
    LexicalScope inner = block.jobOf(compilation.newRegion());
    if (!block.declaresSlots()) {
      for (LocalNames.Named named : LocalNames.in(ast)) {
        if (block.begun(named.declaration()) == null) {
          LocalVariable variable = compilation.declare(block, named.name(), named.declaration());
          inner.addBegun(named.declaration(), variable);
          before.add(
              new Variables.Declare(
                  named.span(), named.name(), compilation.place(variable, block), null, null));
          yields.add(false);
        }
      }
    }
    return compile(ast, inner, HandledJumps.ALL);
  }

  private static Node chain(Ast.Sequence sequence, List<Node> statements, List<Boolean> yields) {
    if (statements.isEmpty()) {
      return new Sequences.Noop(sequence.span());
    }
    if (statements.size() == 1) {
      return statements.getFirst();
    }
    boolean[] after = new boolean[yields.size()];
    for (int i = 0; i < after.length; i++) {
      after[i] = yields.get(i);
    }
    return new Sequences.Chain(sequence.span(), statements.toArray(Node[]::new), after);
  }

  Node scope(Ast.Scope scope, LexicalScope block, HandledJumps seen) {
    return scopeIn(scope, block.scope(), seen);
  }

  /** The statements of a scope, in the block given for them. */
  Node scopeIn(Ast.Scope scope, LexicalScope inner, HandledJumps seen) {
    Node code = body(scope, inner, seen);
    return inner.calls() ? new ScopeEnd.Scope(code) : code;
  }

  /** The statements of a function, whose end is that of its scope. */
  Node body(Ast.Scope scope, LexicalScope inner, HandledJumps seen) {
    boolean waits = scope.body().separators().contains(Flavor.COMMA);
    return sequence(
        scope.body(),
        inner,
        seen,
        body -> waits && inner.calls() ? new ScopeEnd.BeforeBackground(body) : body);
  }

  // ------------------------------------------------------------------ control flow

  Node ifElse(Ast.If statement, LexicalScope block, HandledJumps seen) {
    LexicalScope inner = block.construct();
    return new Conditionals.If(
        statement.span(),
        compile(statement.condition(), inner, HandledJumps.NOTHING),
        compile(statement.thenClause(), inner, seen),
        statement.elseClause() == null ? null : compile(statement.elseClause(), inner, seen));
  }

  Node loop(
      Span span,
      Flavor flavor,
      @Nullable Ast init,
      @Nullable Ast condition,
      @Nullable Ast step,
      Ast body,
      LexicalScope block,
      HandledJumps seen) {
    LexicalScope inner = block.construct();
    Node first = init == null ? null : compile(init, inner, HandledJumps.NOTHING);
    Node test = condition == null ? null : compile(condition, inner, HandledJumps.NOTHING);
    Node next = step == null ? null : compile(step, inner, HandledJumps.NOTHING);
    if (flavor == Flavor.COMMA || flavor == Flavor.AND) {
      return new Loops.Concurrent(span, first, test, next, job(body, inner));
    }
    Node code = compile(body, inner, seen.inLoop());
    return new Loops.Sequential(span, flavor, first, test, next, code);
  }

  Node forEach(Ast.ForEach loop, LexicalScope block, HandledJumps seen) {
    Node range = compile(loop.range(), block, HandledJumps.NOTHING);
    boolean concurrent = loop.flavor() == Flavor.AND || loop.flavor() == Flavor.COMMA;
    LexicalScope inner = concurrent ? block.job(compilation.newRegion()) : block.construct();
    LocalVariable variable =
        compilation.declare(inner, loop.name() == null ? "<turn>" : loop.name(), loop);
    Node body = compile(loop.body(), inner, concurrent ? HandledJumps.ALL : seen.inLoop());
    return new ForEach(
        loop.span(),
        compilation.interpreter(),
        loop.flavor(),
        compilation.place(variable, inner),
        range,
        body);
  }

  Node switchCase(Ast.Switch statement, LexicalScope block, HandledJumps seen) {
    Node value = compile(statement.value(), block, HandledJumps.NOTHING);
    Matching.Case[] cases =
        statement.cases().stream()
            .map(one -> {
              LexicalScope inner = block.construct();
              return new Matching.Case(
                  compilation.expressions.pattern(one.pattern(), inner),
                  one.guard() == null ? null : compile(one.guard(), inner, HandledJumps.NOTHING),
                  sequence(one.body(), inner.scope(), seen));
            })
            .toArray(Matching.Case[]::new);
    Node otherwise =
        statement.defaultClause() == null
            ? null
            : sequence(statement.defaultClause(), block.scope(), seen);
    return new Matching.Switch(statement.span(), value, cases, otherwise);
  }

  Node tryCatch(Ast.Try statement, LexicalScope block, HandledJumps seen) {
    Node body = scope(statement.body(), block, seen);
    Try.Clause[] clauses =
        statement.catches().stream()
            .map(one -> {
              LexicalScope inner = block.construct();
              return new Try.Clause(
                  one.pattern() == null
                      ? null
                      : compilation.expressions.pattern(one.pattern(), inner),
                  one.guard() == null ? null : compile(one.guard(), inner, HandledJumps.NOTHING),
                  scope(one.body(), inner, seen));
            })
            .toArray(Try.Clause[]::new);
    return new Try(
        statement.span(),
        body,
        clauses,
        statement.elseClause() == null ? null : scope(statement.elseClause(), block, seen),
        statement.finallyClause() == null ? null : scope(statement.finallyClause(), block, seen));
  }

  Node assertion(Ast.Assert statement, LexicalScope block) {
    List<Node> claims = new ArrayList<>();
    List<Boolean> yields = new ArrayList<>();
    LexicalScope inner = block.construct();
    for (Ast claim : statement.claims()) {
      // A declaration among the claims is visible to the claims that follow.
      claims.add(
          LocalNames.in(claim).isEmpty()
              ? new Assertion(claim.span(), compilation.claims.claim(claim, inner))
              : new Assertion.DeclarationClaim(
                  claim.span(), compile(claim, inner, HandledJumps.NOTHING)));
      yields.add(true);
    }
    return chain(new Ast.Sequence(statement.span(), statement.claims(), List.of()), claims, yields);
  }
}
