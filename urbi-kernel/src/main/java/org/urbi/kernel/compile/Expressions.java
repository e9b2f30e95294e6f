package org.urbi.kernel.compile;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CallMessageNode;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Matching;
import org.urbi.kernel.node.MessageSend;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Normalized;
import org.urbi.kernel.node.NumericOperator;
import org.urbi.kernel.node.Pattern;
import org.urbi.kernel.node.Sequences;
import org.urbi.kernel.node.Slots;
import org.urbi.kernel.object.Symbol;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.LocalNames;
import org.urbi.lang.source.Span;

/** Compiles expressions. */
final class Expressions {
  private final Compilation compilation;

  Expressions(Compilation compilation) {
    this.compilation = compilation;
  }

  private Interpreter interpreter() {
    return compilation.interpreter();
  }

  private Symbol symbol(String name) {
    return interpreter().world().symbol(name);
  }

  private Node operand(Ast ast, LexicalScope block) {
    return compilation.operand(ast, block);
  }

  private Node[] all(List<Ast> asts, LexicalScope block) {
    return compilation.all(asts, block);
  }

  /** The target of a message; {@code this} when it is implicit. */
  Node target(@Nullable Ast target, Span span, LexicalScope block) {
    return target == null ? new Literals.This(span) : operand(target, block);
  }

  // ------------------------------------------------------------------ messages

  Node message(Ast.Message message, LexicalScope block) {
    if (isNormalized(message, block)) {
      return normalized(message, plain(message, block), null, block);
    }
    return plain(message, block);
  }

  /** Whether it is {@code o.x'n}, for a slot x. */
  static boolean isNormalized(Ast.Message message, LexicalScope block) {
    return message.name().equals("'n")
        && message.arguments() == null
        && message.target() instanceof Ast.Message slot
        && slot.arguments() == null
        && (slot.target() != null || block.find(slot.name()) == null);
  }

  /** {@code o.x'n}, or an assignment to it. */
  Node normalized(Ast.Message message, Node plain, @Nullable Node value, LexicalScope block) {
    Ast.Message slot =
        (Ast.Message) requireNonNull(message.target(), "what is normalized is a slot");
    return new Normalized(
        message.span(),
        compilation.receivers.target(slot.target(), slot.name(), slot.span(), block),
        symbol(slot.name()),
        plain,
        value);
  }

  private Node plain(Ast.Message message, LexicalScope block) {
    Span span = message.span();
    LocalVariable variable = message.target() == null ? block.find(message.name()) : null;
    if (variable != null) {
      Node read = compilation.read(span, variable, block);
      if (message.arguments() == null) {
        return read;
      }
      block.addCall();
      return new MessageSend.OfLocal(span, message.name(), read, all(message.arguments(), block));
    }
    if (!isOperator(message.name())) {
      block.addCall();
    }
    Node target =
        message.target() == null
            ? compilation.receivers.implicit(message.name(), span, block)
            : operand(spread(message, message.target()), block);
    Node[] arguments =
        message.arguments() == null ? null : all(message, message.arguments(), block);
    var sent =
        new MessageSend(span, Slots.lookup(interpreter(), message.name()), target, arguments);
    if (target != null && arguments != null && arguments.length == 1) {
      Node computed = NumericOperator.make(span, target, arguments[0], sent, interpreter());
      if (computed != null) {
        return computed;
      }
    }
    return sent;
  }

  /** What has the name of an operator asks for nothing at the end of a scope. */
  private static boolean isOperator(String name) {
    return !name.isEmpty() && !Symbol.isWord(name) && !name.equals("()");
  }

  /** The target of a message. Errors about a subscripted name show the subscript, too. */
  private static Ast spread(Ast.Message message, Ast target) {
    return message.name().equals("[]")
            && target instanceof Ast.Message name
            && name.target() == null
            && name.arguments() == null
        ? new Ast.Message(message.span(), null, name.name(), null, name.nameSpan())
        : target;
  }

  /**
   * Compiles arguments. What may be executed as a job shares its variables with the caller. An
   * expression hardly ever is: if it is after all, its variables are shared only then ({@link
   * org.urbi.kernel.node.Frame#shareLocals}).
   */
  private Node[] all(Ast.Message message, List<Ast> arguments, LexicalScope block) {
    boolean operator = isOperator(message.name());
    Node[] nodes = new Node[arguments.size()];
    for (int i = 0; i < nodes.length; i++) {
      Ast argument = arguments.get(i);
      boolean job = !operator && isStatement(argument);
      Node code = operand(argument, job ? block.job(compilation.newRegion()) : block);
      nodes[i] =
          argument instanceof Ast.Scope ? new Sequences.Located(argument.span(), code) : code;
    }
    return nodes;
  }

  /**
   * Whether an argument is a statement, which is assumed to be executed later, or by another job.
   * What it declares belongs to the code around it, so a declaration is not.
   */
  private static boolean isStatement(Ast argument) {
    return !(argument instanceof Ast.Message
            || argument instanceof Ast.FloatLiteral
            || argument instanceof Ast.StringLiteral
            || argument instanceof Ast.ListLiteral
            || argument instanceof Ast.TupleLiteral
            || argument instanceof Ast.DictionaryLiteral
            || argument instanceof Ast.Function
            || argument instanceof Ast.This
            || argument instanceof Ast.And
            || argument instanceof Ast.Or
            || argument instanceof Ast.SlotAccess
            || argument instanceof Ast.Property
            || argument instanceof Ast.CallMessage)
        && LocalNames.in(argument).isEmpty();
  }

  Node slotAccess(Ast.SlotAccess access, LexicalScope block) {
    if (access.target() == null) {
      LocalVariable variable = block.find(access.name());
      if (variable != null) {
        return compilation.read(access.span(), variable, block);
      }
    }
    return new Slots.Access(
        access.span(),
        compilation.receivers.target(access.target(), access.name(), access.span(), block),
        Slots.lookup(interpreter(), access.name()));
  }

  Node callMessage(Ast.CallMessage call, LexicalScope block) {
    LexicalScope function = block.nearestFunction();
    if (function == null) {
      return new CallMessageNode(call.span());
    }
    LocalVariable variable = function.local(Functions.CALL);
    if (variable == null) {
      variable =
          compilation.declare(
              function,
              Functions.CALL,
              requireNonNull(function.unit().callKey, "it is a function with a call message"));
    }
    function.unit().usesCall = true;
    return compilation.read(call.span(), variable, block);
  }

  Node doScope(Ast.Do scope, LexicalScope block) {
    if (scope.target() == null) {
      return compilation.operand(scope.body(), block);
    }
    return new Sequences.Do(
        scope.span(),
        operand(scope.target(), block),
        compilation.statements.scopeIn(scope.body(), block.target(), HandledJumps.NOTHING));
  }

  // ------------------------------------------------------------------ patterns, claims

  /**
   * Code with a pattern that declares variables. Where these are slots they are declared behind it,
   * when all has matched, the guard included, which needs them before.
   *
   * @param code compiles it in the block where the pattern declares
   */
  Node matching(LexicalScope block, Function<LexicalScope, Node> code) {
    if (!block.declaresSlots()) {
      return code.apply(block);
    }
    LexicalScope inner = block.construct();
    Node matching = code.apply(inner);
    List<Node> declarations = new ArrayList<>();
    for (LocalVariable variable : inner.variables()) {
      if (variable.key() instanceof Ast.Declaration binding) {
        Span span = binding.nameSpan();
        declarations.add(
            new Slots.Declare(
                span,
                span,
                target(null, span, block),
                symbol(binding.name()),
                compilation.read(span, variable, inner),
                false,
                null));
      }
    }
    return declarations.isEmpty()
        ? matching
        : new Matching.DeclaringSlots(matching, declarations.toArray(Node[]::new));
  }

  /**
   * A pattern; the variables that it declares are added to the block, where they are no slots: see
   * {@link #matching}.
   */
  Pattern pattern(Ast ast, LexicalScope block) {
    if (ast instanceof Ast.Declaration binding
        && binding.value() == null
        && binding.target() == null) {
      LocalVariable variable = compilation.declare(block, binding.name(), binding);
      return new Pattern.Binding(compilation.place(variable, block));
    }
    if (ast instanceof Ast.ListLiteral list) {
      return elements(list.elements(), block, false);
    }
    if (ast instanceof Ast.TupleLiteral tuple) {
      return elements(tuple.elements(), block, true);
    }
    return ast instanceof Ast.DictionaryLiteral dictionary
        ? entries(dictionary, block)
        : new Pattern.Equal(operand(ast, block));
  }

  private Pattern entries(Ast.DictionaryLiteral dictionary, LexicalScope block) {
    List<Node> keys = new ArrayList<>();
    List<Pattern> patterns = new ArrayList<>();
    for (Ast.Entry entry : dictionary.entries()) {
      keys.add(operand(entry.key(), block));
      patterns.add(pattern(entry.value(), block));
    }
    return new Pattern.Entries(keys.toArray(Node[]::new), patterns.toArray(Pattern[]::new));
  }

  private Pattern elements(List<Ast> elements, LexicalScope block, boolean tuple) {
    return new Pattern.Elements(
        elements.stream().map(element -> pattern(element, block)).toArray(Pattern[]::new), tuple);
  }
}
