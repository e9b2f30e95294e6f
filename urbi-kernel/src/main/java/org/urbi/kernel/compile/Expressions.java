package org.urbi.kernel.compile;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.urbi.kernel.event.Emit;
import org.urbi.kernel.event.WatchExpression;
import org.urbi.kernel.node.Assertion;
import org.urbi.kernel.node.CallMessageNode;
import org.urbi.kernel.node.Conditionals;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Message;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Operator;
import org.urbi.kernel.node.Pattern;
import org.urbi.kernel.node.Properties;
import org.urbi.kernel.node.Sequences;
import org.urbi.kernel.node.Slots;
import org.urbi.kernel.object.Symbol;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.print.Printer;
import org.urbi.lang.source.Span;

/** Compiles expressions. */
final class Expressions {
  private static final Set<String> COMPARISONS =
      Set.of("==", "!=", "===", "!==", "<", "<=", ">", ">=", "~=", "=~=");

  private static final Node[] NONE = {};

  private final Compilation compilation;
  private final Definitions definitions;
  private final Assignments assignments;

  Expressions(Compilation compilation) {
    this.compilation = compilation;
    this.definitions = new Definitions(compilation);
    this.assignments = new Assignments(compilation);
  }

  private Interpreter interpreter() {
    return compilation.interpreter();
  }

  private Symbol symbol(String name) {
    return interpreter().world().symbol(name);
  }

  Node compile(Ast ast, Block block) {
    return switch (ast) {
      case Ast.FloatLiteral literal -> new Literals.Number(literal.span(), literal.value());
      case Ast.StringLiteral literal -> new Literals.Text(literal.span(), literal.value());
      case Ast.ListLiteral literal ->
          new Literals.Sequence(literal.span(), all(literal.elements(), block), false);
      case Ast.TupleLiteral literal ->
          new Literals.Sequence(literal.span(), all(literal.elements(), block), true);
      case Ast.DictionaryLiteral literal ->
          new Literals.Dictionary(
              literal.span(),
              all(literal.entries().stream().map(Ast.Entry::key).toList(), block),
              all(literal.entries().stream().map(Ast.Entry::value).toList(), block));
      case Ast.This it -> new Literals.This(it.span());
      case Ast.CallMessage call -> callMessage(call, block);
      case Ast.Message message -> message(message, block);
      case Ast.And and ->
          new Conditionals.Logical(
              and.span(), true, operand(and.left(), block), operand(and.right(), block));
      case Ast.Or or ->
          new Conditionals.Logical(
              or.span(), false, operand(or.left(), block), operand(or.right(), block));
      case Ast.SlotAccess access -> slotAccess(access, block);
      case Ast.Property property ->
          new Properties.Read(
              property.span(),
              target(property.target(), property.span(), block),
              symbol(property.slot()),
              property.name());
      case Ast.Function function -> compilation.functions.compile(function, block);
      case Ast.Do scope -> doScope(scope, block);
      case Ast.Emit emit ->
          new Emit(
              emit.span(),
              operand(emit.event(), block),
              emit.arguments() == null ? NONE : all(emit.arguments(), block),
              emit.duration() == null ? null : operand(emit.duration(), block));
      case Ast.Watch watch ->
          new WatchExpression(
              watch.span(), operand(watch.expression(), block.job(compilation.newRegion())));
      case Ast.Declaration declaration -> definitions.declaration(declaration, block);
      case Ast.FunctionDefinition definition -> definitions.function(definition, block);
      case Ast.ClassDefinition definition -> definitions.classDefinition(definition, block);
      case Ast.PackageDefinition definition -> definitions.packageDefinition(definition, block);
      case Ast.Import definition -> definitions.importDefinition(definition, block);
      case Ast.EnumDefinition definition -> definitions.enumDefinition(definition, block);
      case Ast.Accessor accessor -> definitions.accessor(accessor, block);
      case Ast.Assignment assignment -> assignments.assignment(assignment, block);
      case Ast.OperatorAssignment assignment -> assignments.inPlace(assignment, block);
      case Ast.Postfix postfix -> assignments.postfix(postfix, block);
      case Ast.Trajectory trajectory -> assignments.trajectory(trajectory, block);
      default -> compilation.statements.compile(ast, block, Seen.NOTHING);
    };
  }

  Node operand(Ast ast, Block block) {
    return compilation.statements.compile(ast, block, Seen.NOTHING);
  }

  Node[] all(List<Ast> asts, Block block) {
    return compilation.statements.compileAll(asts, block);
  }

  /** The target of a message; {@code this} when it is implicit. */
  Node target(Ast target, Span span, Block block) {
    return target == null ? new Literals.This(span) : operand(target, block);
  }

  // ------------------------------------------------------------------ messages

  private Node message(Ast.Message message, Block block) {
    Span span = message.span();
    if (isScopeTag(message)) {
      return scopeTag(message, block);
    }
    if (message.name().equals("redefinitionMode") && block.nearestScope() != null) {
      block.nearestScope().setRedefines();
    }
    if (message.target() == null) {
      Variable variable = block.find(message.name());
      if (variable != null) {
        Node read = compilation.read(span, variable, block);
        return message.arguments() == null
            ? read
            : new Message.OfLocal(span, message.name(), read, all(message.arguments(), block));
      }
    }
    Node target = message.target() == null ? null : operand(message.target(), block);
    Node[] arguments = message.arguments() == null ? null : all(message.arguments(), block);
    var sent = new Message(span, Slots.lookup(interpreter(), message.name()), target, arguments);
    if (target != null && arguments != null && arguments.length == 1) {
      Node computed = Operator.make(span, target, arguments[0], sent, interpreter());
      if (computed != null) {
        return computed;
      }
    }
    return sent;
  }

  /** {@code scopeTag}, and the manual's {@code Tag.scope}. */
  boolean isScopeTag(Ast.Message message) {
    if (message.arguments() != null) {
      return false;
    }
    return message.target() == null
        ? message.name().equals("scopeTag")
        : message.name().equals("scope")
            && message.target() instanceof Ast.Message tag
            && tag.target() == null
            && tag.arguments() == null
            && tag.name().equals("Tag");
  }

  private Node scopeTag(Ast.Message message, Block block) {
    Block scope = block.nearestScope();
    if (scope == null) {
      return new Message(message.span(), Slots.lookup(interpreter(), "connectionTag"), null, null);
    }
    Variable variable = scope.local(Statements.SCOPE_TAG);
    if (variable == null) {
      variable = compilation.declare(scope, Statements.SCOPE_TAG, message);
    }
    return compilation.read(message.span(), variable, block);
  }

  private Node slotAccess(Ast.SlotAccess access, Block block) {
    if (access.target() == null) {
      Variable variable = block.find(access.name());
      if (variable != null) {
        return compilation.read(access.span(), variable, block);
      }
    }
    return new Slots.Access(
        access.span(),
        target(access.target(), access.span(), block),
        Slots.lookup(interpreter(), access.name()));
  }

  private Node callMessage(Ast.CallMessage call, Block block) {
    block.unit().usesCall = true;
    return new CallMessageNode(call.span());
  }

  private Node doScope(Ast.Do scope, Block block) {
    if (scope.target() == null) {
      return compilation.statements.compile(scope.body(), block, Seen.NOTHING);
    }
    return new Sequences.Do(
        scope.span(),
        operand(scope.target(), block),
        compilation.statements.scopeIn(scope.body(), block.target(), Seen.NOTHING));
  }

  // ------------------------------------------------------------------ patterns, claims

  /** A pattern; the variables that it declares are added to the block. */
  Pattern pattern(Ast ast, Block block) {
    return switch (ast) {
      case Ast.Declaration binding when binding.value() == null && binding.target() == null ->
          block.declaresSlots()
              ? new Pattern.SlotBinding(symbol(binding.name()), binding.nameSpan())
              : new Pattern.Binding(
                  compilation.place(compilation.declare(block, binding.name(), binding), block));
      case Ast.ListLiteral list -> elements(list.elements(), block, false);
      case Ast.TupleLiteral tuple -> elements(tuple.elements(), block, true);
      case Ast.DictionaryLiteral dictionary -> {
        List<Node> keys = new ArrayList<>();
        List<Pattern> patterns = new ArrayList<>();
        for (Ast.Entry entry : dictionary.entries()) {
          keys.add(operand(entry.key(), block));
          patterns.add(pattern(entry.value(), block));
        }
        yield new Pattern.Entries(keys.toArray(Node[]::new), patterns.toArray(Pattern[]::new));
      }
      default -> new Pattern.Equal(operand(ast, block));
    };
  }

  private Pattern elements(List<Ast> elements, Block block, boolean tuple) {
    return new Pattern.Elements(
        elements.stream().map(element -> pattern(element, block)).toArray(Pattern[]::new), tuple);
  }

  /** The claim of an assertion. */
  Assertion.Claim claim(Ast ast, Block block) {
    String text = claimText(ast);
    boolean local =
        ast instanceof Ast.Message message
            && message.target() == null
            && block.find(message.name()) != null;
    if (ast instanceof Ast.Message message && !local && !isScopeTag(message)) {
      return new Assertion.Claim(
          text,
          null,
          message.target() == null ? null : operand(message.target(), block),
          symbol(message.name()),
          message.arguments() == null ? List.of() : List.of(all(message.arguments(), block)));
    }
    return new Assertion.Claim(text, operand(ast, block), null, null, List.of());
  }

  /** Of a comparison, the message shows what is compared. */
  private static String claimText(Ast ast) {
    return ast instanceof Ast.Message message
            && message.target() != null
            && message.arguments() != null
            && message.arguments().size() == 1
            && COMPARISONS.contains(message.name())
        ? Printer.print(message.target())
            + " "
            + message.name()
            + " "
            + Printer.print(message.arguments().getFirst())
        : Printer.print(ast);
  }
}
