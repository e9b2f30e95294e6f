package org.urbi.kernel.compile;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Matching;
import org.urbi.kernel.node.MessageSend;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Pattern;
import org.urbi.kernel.node.Properties;
import org.urbi.kernel.node.Slots;
import org.urbi.kernel.node.Trajectory;
import org.urbi.kernel.node.Variables;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.source.Span;

/** Compiles assignments of all kinds. */
final class Assignments {
  private final Compilation compilation;

  Assignments(Compilation compilation) {
    this.compilation = compilation;
  }

  private Interpreter interpreter() {
    return compilation.interpreter();
  }

  private Node operand(Ast ast, LexicalScope block) {
    return compilation.operand(ast, block);
  }

  private Node target(@Nullable Ast target, Span span, LexicalScope block) {
    return compilation.expressions.target(target, span, block);
  }

  Node assignment(Ast.Assignment assignment, LexicalScope block) {
    Span span = assignment.span();
    Ast target = assignment.target();
    if (target instanceof Ast.Message message
        && (message.arguments() == null || message.name().equals("[]"))) {
      return toMessage(span, message, assignment.value(), block);
    }
    if (target instanceof Ast.Property property) {
      return new Properties.Write(
          property.span(),
          compilation.receivers.target(property.target(), property.slot(), span, block),
          interpreter().world().symbol(property.slot()),
          property.name(),
          operand(assignment.value(), block));
    }
    Node value = operand(assignment.value(), block);
    // An error in assigning to a call is reported at the location of the assignment.
    Ast assigned =
        target instanceof Ast.Message call
            ? new Ast.Message(span, call.target(), call.name(), call.arguments(), call.nameSpan())
            : target;
    return compilation.expressions.matching(
        block, inner -> new Matching.Destructure(span, destructuring(assigned, inner), value));
  }

  private Node toMessage(Span span, Ast.Message message, Ast value, LexicalScope block) {
    if (message.arguments() != null) {
      // a[i] = v is a.'[]='(i, v).
      List<Ast> arguments = new ArrayList<>(message.arguments());
      arguments.add(value);
      return new MessageSend(
          span,
          Slots.lookup(interpreter(), message.name() + "="),
          message.target() == null ? null : operand(message.target(), block),
          compilation.all(arguments, block));
    }
    if (message.target() == null) {
      LocalVariable variable = block.find(message.name());
      if (variable != null) {
        return new Variables.Assign(
            message.span(), compilation.place(variable, block), operand(value, block));
      }
    }
    Node assigned = operand(value, block);
    Node plain =
        new Slots.Assign(
            span,
            message.span(),
            compilation.receivers.target(message.target(), message.name(), message.span(), block),
            interpreter().world().symbol(message.name()),
            assigned);
    return Expressions.isNormalized(message, block)
        ? compilation.expressions.normalized(message, plain, assigned, block)
        : plain;
  }

  /** A local variable in a pattern on the left of an assignment is assigned, not compared. */
  private Pattern destructuring(Ast pattern, LexicalScope block) {
    if (pattern instanceof Ast.Message name && name.target() == null && name.arguments() == null) {
      LocalVariable variable = block.find(name.name());
      return variable == null
          ? compilation.expressions.pattern(name, block)
          : new Matching.AssignedPlace(compilation.place(variable, block));
    }
    if (pattern instanceof Ast.ListLiteral list) {
      return elements(list.elements(), block, false);
    }
    return pattern instanceof Ast.TupleLiteral tuple
        ? elements(tuple.elements(), block, true)
        : compilation.expressions.pattern(pattern, block);
  }

  private Pattern elements(List<Ast> elements, LexicalScope block, boolean tuple) {
    return new Pattern.Elements(
        elements.stream().map(each -> destructuring(each, block)).toArray(Pattern[]::new), tuple);
  }

  /** {@code a += b} is {@code a = a.'+='(b)}, with the parts of a evaluated once. */
  Node inPlace(Ast.OperatorAssignment assignment, LexicalScope block) {
    return inPlace(
        assignment.span(),
        assignment.target(),
        assignment.operator(),
        operand(assignment.value(), block),
        block);
  }

  /** {@code a++} gives the value of {@code a}, and sets it to {@code a.'++'}. */
  Node postfix(Ast.Postfix postfix, LexicalScope block) {
    return inPlace(postfix.span(), postfix.target(), postfix.operator(), null, block);
  }

  private Node inPlace(
      Span span, Ast target, String operator, @Nullable Node operand, LexicalScope block) {
    return new CompoundAssignment(
        span, interpreter(), access(span, target, block), operator, operand);
  }

  /** What is read and written. */
  private CompoundAssignment.Access access(Span span, Ast target, LexicalScope block) {
    if (target instanceof Ast.Message message) {
      return message.arguments() == null
          ? named(span, message, block)
          : new CompoundAssignment.Element(
              target(message.target(), span, block),
              compilation.all(message.arguments(), block),
              Slots.lookup(interpreter(), message.name()),
              Slots.lookup(interpreter(), message.name() + "="));
    }
    return target instanceof Ast.Property property
        ? new CompoundAssignment.OfProperty(
            compilation.receivers.target(property.target(), property.slot(), span, block),
            interpreter().world().symbol(property.slot()),
            property.name())
        : new CompoundAssignment.Constant(operand(target, block));
  }

  private CompoundAssignment.Access named(Span span, Ast.Message name, LexicalScope block) {
    LocalVariable variable = name.target() == null ? block.find(name.name()) : null;
    return variable == null
        ? new CompoundAssignment.Slot(
            compilation.receivers.target(name.target(), name.name(), name.span(), block),
            Slots.lookup(interpreter(), name.name()),
            name.span())
        : new CompoundAssignment.OfVariable(
            compilation.read(span, variable, block), compilation.place(variable, block));
  }

  /** {@code x = 10 time: 5s}: a function to read, one to write, and the attributes. */
  Node trajectory(Ast.Trajectory trajectory, LexicalScope block) {
    Span span = trajectory.span();
    Node target = operand(trajectory.target(), block);
    var body = new Ast.Message(span, null, "<value>", null, span);
    LexicalScope writer = block.construct();
    LocalVariable value = compilation.declare(writer, "<value>", trajectory);
    Node write = assignment(new Ast.Assignment(span, trajectory.target(), body), writer);
    String[] names = trajectory.modifiers().stream().map(Ast.Modifier::name).toArray(String[]::new);
    Node[] values =
        trajectory.modifiers().stream()
            .map(modifier -> operand(modifier.value(), block))
            .toArray(Node[]::new);
    Trajectory.Slot slot = null;
    if (trajectory.target() instanceof Ast.Message message
        && message.arguments() == null
        && (message.target() != null || block.find(message.name()) == null)) {
      slot =
          new Trajectory.Slot(
              compilation.receivers.target(message.target(), message.name(), message.span(), block),
              interpreter().world().symbol(message.name()));
    }
    return new Trajectory(
        span,
        target,
        slot,
        compilation.place(value, writer),
        write,
        trajectory.value() == null
            ? new Literals.Number(span, Double.NaN)
            : operand(trajectory.value(), block),
        names,
        values);
  }
}
