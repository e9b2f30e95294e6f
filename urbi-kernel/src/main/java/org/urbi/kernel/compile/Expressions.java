package org.urbi.kernel.compile;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.urbi.kernel.event.Emit;
import org.urbi.kernel.event.WatchExpression;
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
import org.urbi.lang.source.Span;

/** Compiles expressions. */
final class Expressions {
  private static final Node[] NONE = {};

  /** Functions of the library that execute their argument in another job. */
  private static final Set<String> DETACHING = Set.of("detach", "disown");

  /** What changes the way in which a scope is executed. */
  private static final Set<String> MODES = Set.of("redefinitionMode", "nonInterruptible");

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
    // A chain of tests: the JDK builds a switch over types when it is first run, which costs
    // more than all the rest of starting a kernel.
    if (ast instanceof Ast.FloatLiteral literal) {
      return new Literals.Number(literal.span(), literal.value());
    }
    if (ast instanceof Ast.StringLiteral literal) {
      return new Literals.Text(literal.span(), literal.value());
    }
    if (ast instanceof Ast.ListLiteral literal) {
      return new Literals.Sequence(literal.span(), all(literal.elements(), block), false);
    }
    if (ast instanceof Ast.TupleLiteral literal) {
      return new Literals.Sequence(literal.span(), all(literal.elements(), block), true);
    }
    if (ast instanceof Ast.DictionaryLiteral literal) {
      return new Literals.Dictionary(
          literal.span(),
          all(literal.entries().stream().map(Ast.Entry::key).toList(), block),
          all(literal.entries().stream().map(Ast.Entry::value).toList(), block));
    }
    if (ast instanceof Ast.This it) {
      return new Literals.This(it.span());
    }
    if (ast instanceof Ast.CallMessage call) {
      return callMessage(call, block);
    }
    if (ast instanceof Ast.Message message) {
      return message(message, block);
    }
    if (ast instanceof Ast.And and) {
      return new Conditionals.Logical(
          and.span(), true, operand(and.left(), block), operand(and.right(), block));
    }
    if (ast instanceof Ast.Or or) {
      return new Conditionals.Logical(
          or.span(), false, operand(or.left(), block), operand(or.right(), block));
    }
    if (ast instanceof Ast.SlotAccess access) {
      return slotAccess(access, block);
    }
    if (ast instanceof Ast.Property property) {
      return new Properties.Read(
          property.span(),
          compilation.receivers.target(property.target(), property.slot(), property.span(), block),
          symbol(property.slot()),
          property.name());
    }
    if (ast instanceof Ast.Function function) {
      return compilation.functions.compile(function, block);
    }
    if (ast instanceof Ast.Do scope) {
      return doScope(scope, block);
    }
    if (ast instanceof Ast.Emit emit) {
      return new Emit(
          emit.span(),
          operand(emit.event(), block),
          emit.arguments() == null ? NONE : all(emit.arguments(), block),
          emit.duration() == null ? null : operand(emit.duration(), block));
    }
    if (ast instanceof Ast.Watch watch) {
      return new WatchExpression(
          watch.span(), operand(watch.expression(), block.job(compilation.newRegion())));
    }
    if (ast instanceof Ast.Declaration declaration) {
      return definitions.declaration(declaration, block);
    }
    if (ast instanceof Ast.FunctionDefinition definition) {
      return definitions.function(definition, block);
    }
    if (ast instanceof Ast.ClassDefinition definition) {
      return definitions.classDefinition(definition, block);
    }
    if (ast instanceof Ast.PackageDefinition definition) {
      return definitions.packageDefinition(definition, block);
    }
    if (ast instanceof Ast.Import definition) {
      return compilation.receivers.importFrom(definition, block);
    }
    if (ast instanceof Ast.EnumDefinition definition) {
      return definitions.enumDefinition(definition, block);
    }
    if (ast instanceof Ast.Accessor accessor) {
      return definitions.accessor(accessor, block);
    }
    if (ast instanceof Ast.Assignment assignment) {
      return assignments.assignment(assignment, block);
    }
    if (ast instanceof Ast.OperatorAssignment assignment) {
      return assignments.inPlace(assignment, block);
    }
    if (ast instanceof Ast.Postfix postfix) {
      return assignments.postfix(postfix, block);
    }
    if (ast instanceof Ast.Trajectory trajectory) {
      return assignments.trajectory(trajectory, block);
    }
    return compilation.statements.compile(ast, block, Seen.NOTHING);
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
    if (MODES.contains(message.name()) && block.nearestScope() != null) {
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
    Node target =
        message.target() == null
            ? compilation.receivers.implicit(message.name(), span, block)
            : operand(message.target(), block);
    Node[] arguments = message.arguments() == null ? null : all(message, block);
    var sent = new Message(span, Slots.lookup(interpreter(), message.name()), target, arguments);
    if (target != null && arguments != null && arguments.length == 1) {
      Node computed = Operator.make(span, target, arguments[0], sent, interpreter());
      if (computed != null) {
        return computed;
      }
    }
    return sent;
  }

  /** The arguments; those which become jobs share the variables that they use. */
  private Node[] all(Ast.Message message, Block block) {
    return all(
        message.arguments(),
        DETACHING.contains(message.name()) ? block.job(compilation.newRegion()) : block);
  }

  /** {@code scopeTag}, and the manual's {@code System.scopeTag} and {@code Tag.scope}. */
  boolean isScopeTag(Ast.Message message) {
    if (message.arguments() != null) {
      return false;
    }
    if (message.target() == null) {
      return message.name().equals("scopeTag");
    }
    return message.target() instanceof Ast.Message owner
        && owner.target() == null
        && owner.arguments() == null
        && (owner.name().equals("Tag") && message.name().equals("scope")
            || owner.name().equals("System") && message.name().equals("scopeTag"));
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
        compilation.receivers.target(access.target(), access.name(), access.span(), block),
        Slots.lookup(interpreter(), access.name()));
  }

  private Node callMessage(Ast.CallMessage call, Block block) {
    Block function = block.nearestFunction();
    if (function == null) {
      return new CallMessageNode(call.span());
    }
    Variable variable = function.local(Functions.CALL);
    if (variable == null) {
      variable = compilation.declare(function, Functions.CALL, function.unit().callKey);
    }
    function.unit().usesCall = true;
    return compilation.read(call.span(), variable, block);
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
}
