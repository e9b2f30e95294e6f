package org.urbi.lang.ast;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.source.Span;

/**
 * The syntax tree of urbiscript, as written: no sugar is removed here except that operators are
 * messages, since {@code a + b} <em>is</em> {@code a.'+'(b)} (manual, "Operators").
 *
 * <p>Trees are immutable and know nothing of the run time; tools (formatter, language server) stand
 * on them as the kernel does. A {@code null} component means "absent in the source" and is
 * documented where it may happen.
 */
public sealed interface Ast extends Declaring {
  /** Calls the method of the visitor that is for this kind of node. */
  <R> R accept(AstVisitor<R> visitor);

  /** The four statement separators, and the flavors of the loops. */
  enum Flavor {
    SEMICOLON(";"),
    PIPE("|"),
    COMMA(","),
    AND("&");

    private final String text;

    Flavor(String text) {
      this.text = text;
    }

    /** The separator as written. */
    public String text() {
      return text;
    }
  }

  // --------------------------------------------------------------- literals and names

  /** A number; angles and durations are already radians and seconds. */
  record FloatLiteral(Span span, double value) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** A string: every {@code char} is one byte (0 to 255); adjacent literals are glued already. */
  record StringLiteral(Span span, String value) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  record ListLiteral(Span span, List<Ast> elements) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  record TupleLiteral(Span span, List<Ast> elements) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  record DictionaryLiteral(Span span, List<Entry> entries) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code key => value}. */
  record Entry(Ast key, Ast value) {}

  /** {@code this}. */
  record This(Span span) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code call}, the call message of the running function. */
  record CallMessage(Span span) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A message: {@code target.name(arguments)}. Also identifiers ({@code x} has neither target nor
   * arguments), calls ({@code f(1)}), operators ({@code a + b} is named "+", {@code -a} "-" with no
   * arguments, {@code a[i]} "[]", {@code a in b} is {@code b.has(a)}, {@code a not in b} {@code
   * b.hasNot(a)}).
   *
   * @param target null when implicit
   * @param arguments null when there are no parentheses
   * @param nameSpan where the name alone is written
   */
  record Message(
      Span span, @Nullable Ast target, String name, @Nullable List<Ast> arguments, Span nameSpan)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code a && b}. */
  record And(Span span, Ast left, Ast right) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code a || b}. */
  record Or(Span span, Ast left, Ast right) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code target.&name} (or {@code &name}, target null): the slot's value, not evaluated. */
  record SlotAccess(Span span, @Nullable Ast target, String name) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code target.slot->property} ({@code slot->property}, target null). */
  record Property(Span span, @Nullable Ast target, String slot, String name) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  // --------------------------------------------------------------- declarations, assignments

  /**
   * {@code var name = value}, {@code var target.name = value}; inside a pattern, a binding.
   *
   * @param target null for {@code var name}
   * @param value null when there is no initial value
   * @param constant {@code const var}
   * @param type the type of {@code var x : Type}, or null
   */
  record Declaration(
      Span span,
      @Nullable Ast target,
      String name,
      @Nullable Ast value,
      boolean constant,
      @Nullable Ast type,
      Span nameSpan)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * {@code target = value}. The target is a {@link Message} (identifier, slot, or subscript), a
   * {@link Property}, or a pattern: a literal list, tuple or dictionary.
   */
  record Assignment(Span span, Ast target, Ast value) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code target += value}; {@code operator} is "+=", "-=", "*=", "/=", "%=" or "^=". */
  record OperatorAssignment(Span span, Ast target, String operator, Ast value) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code target++} and {@code target--}; {@code operator} is "++" or "--". */
  record Postfix(Span span, Ast target, String operator) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code target = value time: 5s ampli: 20}; value is null in {@code x = sin: 1s ampli: 2}. */
  record Trajectory(Span span, Ast target, @Nullable Ast value, List<Modifier> modifiers)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code name: value} of a trajectory. */
  record Modifier(String name, Ast value) {}

  // --------------------------------------------------------------- functions, classes

  /**
   * {@code function (…) {…}} or {@code closure (…) {…}}.
   *
   * @param formals null for a lazy function (no parentheses)
   */
  record Function(Span span, boolean closure, @Nullable List<Formal> formals, Scope body)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * {@code function target.name (…) {…}}.
   *
   * @param name a {@link Message} without arguments
   */
  record FunctionDefinition(Span span, Message name, Function function) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * {@code get name() {…}} and {@code set name(var v) {…}}; the function's name is {@code name}.
   */
  record Accessor(Span span, boolean setter, Message name, Function function) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * A formal argument.
   *
   * @param defaultValue null when there is none
   * @param variadic {@code args[]}
   * @param type the type of {@code var x : Type}, or null
   */
  record Formal(
      Span span, String name, @Nullable Ast defaultValue, boolean variadic, @Nullable Ast type)
      implements Declaring {}

  /**
   * {@code class lvalue : protos {…}}.
   *
   * @param name a {@link Message} without arguments
   * @param body null in {@code class Foo;}
   */
  record ClassDefinition(Span span, Message name, List<Ast> protos, @Nullable Scope body)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code package lvalue {…}}. */
  record PackageDefinition(Span span, Message name, Scope body) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code import a.b.c} ({@code import a.b.*} when {@code all}). */
  record Import(Span span, List<String> path, boolean all) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code enum lvalue { a, b, c }}. */
  record EnumDefinition(Span span, Message name, List<String> values) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  // --------------------------------------------------------------- composition

  /**
   * Statements and their separators. {@code separators} has as many elements as {@code statements},
   * or one less: a last statement without separator. A trailing {@code |} or {@code &} is followed
   * by an explicit empty {@link Scope}. Sequences nest by precedence: {@code ;} and {@code ,}
   * weakest and mixed in one sequence, then {@code |}, then {@code &}, the strongest (tutorial,
   * "Parallelism operators").
   */
  record Sequence(Span span, List<Ast> statements, List<Flavor> separators) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code {…}}; the body may be an empty sequence. */
  record Scope(Span span, Sequence body) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code do (target) {…}}; target is null for {@code do {…}}. */
  record Do(Span span, @Nullable Ast target, Scope body) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** An empty statement, as in {@code ;;}. */
  record Noop(Span span) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  // --------------------------------------------------------------- control flow

  /** {@code if (condition) thenClause else elseClause}; elseClause may be null. */
  record If(Span span, Ast condition, Ast thenClause, @Nullable Ast elseClause) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  record While(Span span, Flavor flavor, Ast condition, Ast body) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** C-like {@code for}; each of the three clauses may be null. */
  record For(
      Span span,
      Flavor flavor,
      @Nullable Ast init,
      @Nullable Ast condition,
      @Nullable Ast step,
      Ast body)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code for (var name : range) body}; name is null in {@code for (n) body}. */
  record ForEach(Span span, Flavor flavor, @Nullable String name, Ast range, Ast body)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  record Loop(Span span, Flavor flavor, Ast body) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code defaultClause} may be null. */
  record Switch(Span span, Ast value, List<Case> cases, @Nullable Sequence defaultClause)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code case pattern if guard: body}; guard may be null. */
  record Case(Span span, Ast pattern, @Nullable Ast guard, Sequence body) {}

  /** {@code value} may be null. */
  record Return(Span span, @Nullable Ast value) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  record Break(Span span) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  record Continue(Span span) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code value} is null in a rethrow. */
  record Throw(Span span, @Nullable Ast value) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code elseClause} and {@code finallyClause} may be null. */
  record Try(
      Span span,
      Scope body,
      List<Catch> catches,
      @Nullable Scope elseClause,
      @Nullable Scope finallyClause)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code catch (pattern if guard) {…}}; pattern and guard may be null. */
  record Catch(Span span, @Nullable Ast pattern, @Nullable Ast guard, Scope body) {}

  /** {@code assert (claim)} (one claim) or {@code assert {claim; …}} (any number). */
  record Assert(Span span, boolean block, List<Ast> claims) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  // --------------------------------------------------------------- parallel and events

  /** {@code tag: body}. */
  record Tagged(Span span, Ast tag, Ast body) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** What {@code at}, {@code whenever} and {@code waituntil} wait for. */
  sealed interface Condition {
    /** The time for which it must hold, or null. */
    Ast duration();
  }

  /** {@code expression ~ duration}. */
  record WhenTrue(Span span, Ast expression, @Nullable Ast duration) implements Condition {}

  /**
   * {@code event?(patterns) if guard ~ duration}.
   *
   * @param patterns null when there are no parentheses: any payload
   * @param guard may be null
   */
  record WhenEmitted(
      Span span,
      Ast event,
      @Nullable List<Ast> patterns,
      @Nullable Ast guard,
      @Nullable Ast duration)
      implements Condition {}

  /** {@code at sync? (condition) body onleave onLeave}; onLeave may be null. */
  record At(Span span, boolean sync, Condition condition, Ast body, @Nullable Ast onLeave)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code whenever (condition) body else elseClause}; elseClause may be null. */
  record Whenever(Span span, Condition condition, Ast body, @Nullable Ast elseClause)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  record WaitUntil(Span span, Condition condition) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  record Watch(Span span, Ast expression) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /**
   * {@code event!(arguments) ~ duration}.
   *
   * @param arguments null when there are no parentheses
   * @param duration may be null
   */
  record Emit(Span span, Ast event, @Nullable List<Ast> arguments, @Nullable Ast duration)
      implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  record Every(Span span, Flavor flavor, Ast period, Ast body) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code timeout (duration) body}. */
  record Timeout(Span span, Ast duration, Ast body) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code stopif (condition) body}. */
  record StopIf(Span span, Condition condition, Ast body) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }

  /** {@code freezeif (condition) body}. */
  record FreezeIf(Span span, Condition condition, Ast body) implements Ast {
    @Override
    public <R> R accept(AstVisitor<R> visitor) {
      return visitor.visit(this);
    }
  }
}
