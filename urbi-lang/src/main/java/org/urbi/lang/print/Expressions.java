package org.urbi.lang.print;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;

/** Prints what may stand where a value is expected. */
final class Expressions {
  private Expressions() {}

  /** An expression of any precedence; a statement goes between braces. */
  static String expression(Ast tree) {
    return form(tree).get();
  }

  /**
   * How it is printed. Not by this method: one that tells all the forms apart needs so much stack
   * that deep trees could not be printed by the threads that have parsed them.
   */
  private static Supplier<String> form(Ast tree) {
    return switch (tree) {
      case Ast.FloatLiteral number -> () -> FloatFormat.format(number.value());
      case Ast.StringLiteral string -> () -> StringEscape.quote(string.value());
      case Ast.ListLiteral list -> () -> list(list.elements());
      case Ast.TupleLiteral tuple -> () -> tuple(tuple.elements());
      case Ast.DictionaryLiteral dictionary -> () -> dictionary(dictionary.entries());
      case Ast.This self -> () -> "this";
      case Ast.CallMessage call -> () -> "call";
      case Ast.Message message -> () -> message(message);
      case Ast.And and -> () -> and(and);
      case Ast.Or or -> () -> or(or);
      case Ast.SlotAccess slot -> () -> slot(slot);
      case Ast.Property property -> () -> property(property);
      case Ast.Declaration declaration -> () -> declaration(declaration);
      case Ast.Assignment assignment -> () -> assign(assignment.target(), "=", assignment.value());
      case Ast.OperatorAssignment assignment ->
          () -> assign(assignment.target(), assignment.operator(), assignment.value());
      case Ast.Postfix postfix -> () -> lvalue(postfix.target()).concat(postfix.operator());
      case Ast.Trajectory trajectory -> () -> trajectory(trajectory);
      case Ast.Function function -> () -> function(function);
      case Ast.FunctionDefinition definition -> () -> Definitions.function(definition);
      case Ast.Watch watch -> () -> watch(watch);
      case Ast.Emit emit when emit.duration() == null -> () -> emission(emit);
      case Ast.Do block -> () -> Statements.doBlock(block);
      case Ast.Scope scope -> () -> Statements.scope(scope);
      default -> () -> Statements.clause(tree);
    };
  }

  private static String list(List<Ast> elements) {
    return "[" + values(elements) + "]";
  }

  private static String and(Ast.And and) {
    return conjunct(and.left()) + " && " + primary(and.right());
  }

  private static String or(Ast.Or or) {
    return disjunct(or.left()) + " || " + conjunct(or.right());
  }

  private static String slot(Ast.SlotAccess slot) {
    return target(slot.target(), ".") + "&" + StringEscape.name(slot.name());
  }

  private static String property(Ast.Property property) {
    return target(property.target(), ".")
        + StringEscape.name(property.slot())
        + "->"
        + StringEscape.name(property.name());
  }

  private static String assign(Ast target, String operator, Ast value) {
    return lvalue(target) + " " + operator + " " + expression(value);
  }

  private static String watch(Ast.Watch watch) {
    return "watch(" + expression(watch.expression()) + ")";
  }

  static String values(List<Ast> values) {
    var text = new StringBuilder();
    for (Ast value : values) {
      text.append(text.isEmpty() ? "" : ", ").append(expression(value));
    }
    return text.toString();
  }

  static <T> String join(List<T> parts, Function<T, String> print) {
    var text = new StringBuilder();
    for (T part : parts) {
      text.append(text.isEmpty() ? "" : ", ").append(print.apply(part));
    }
    return text.toString();
  }

  static String arguments(@Nullable List<Ast> arguments) {
    return arguments == null ? "" : "(" + values(arguments) + ")";
  }

  private static String tuple(List<Ast> elements) {
    return "(" + values(elements) + (elements.size() == 1 ? ",)" : ")");
  }

  private static String dictionary(List<Ast.Entry> entries) {
    if (entries.isEmpty()) {
      return "[ => ]";
    }
    var text = new StringBuilder("[\n");
    for (Ast.Entry entry : entries) {
      String line = expression(entry.key()) + " => " + expression(entry.value()) + ",";
      text.append(Printer.indent(line)).append('\n');
    }
    return text.append(']').toString();
  }

  private static String message(Ast.Message message) {
    // Chains are longer than anything else: they are followed without recursion.
    Deque<Ast.Message> chain = new ArrayDeque<>();
    Ast target = message;
    while (target instanceof Ast.Message link) {
      chain.push(link);
      target = link.target();
    }
    var text = new StringBuilder(target == null ? "" : primary(target) + ".");
    while (!chain.isEmpty()) {
      Ast.Message link = chain.pop();
      text.append(StringEscape.name(link.name())).append(arguments(link.arguments()));
      text.append(chain.isEmpty() ? "" : ".");
    }
    return text.toString();
  }

  /** What a message is sent to, and what separates them; nothing for an implicit target. */
  private static String target(@Nullable Ast tree, String separator) {
    return tree == null ? "" : primary(tree) + separator;
  }

  /** What binds at least as tight as a message. */
  static String primary(Ast tree) {
    boolean tight =
        switch (tree) {
          case Ast.FloatLiteral number -> number.value() >= 0;
          case Ast.StringLiteral string -> true;
          case Ast.ListLiteral list -> true;
          case Ast.TupleLiteral tuple -> true;
          case Ast.DictionaryLiteral dictionary -> true;
          case Ast.This self -> true;
          case Ast.CallMessage call -> true;
          case Ast.Message message -> true;
          case Ast.SlotAccess slot -> true;
          case Ast.Property property -> true;
          case Ast.Function function -> true;
          case Ast.FunctionDefinition definition -> true;
          case Ast.Watch watch -> true;
          case Ast.Do block -> true;
          case Ast.Emit emit -> true;
          case Ast.And and -> false;
          case Ast.Or or -> false;
          case Ast.Declaration declaration -> false;
          case Ast.Assignment assignment -> false;
          case Ast.OperatorAssignment assignment -> false;
          case Ast.Postfix postfix -> true;
          case Ast.Trajectory trajectory -> false;
          default -> true;
        };
    return tight ? expression(tree) : "(" + expression(tree) + ")";
  }

  private static String conjunct(Ast tree) {
    return tree instanceof Ast.And ? expression(tree) : primary(tree);
  }

  private static String disjunct(Ast tree) {
    return tree instanceof Ast.Or ? expression(tree) : conjunct(tree);
  }

  /** What may be assigned to: a subscript is written as one there. */
  static String lvalue(Ast tree) {
    if (tree instanceof Ast.Message message
        && message.name().equals("[]")
        && message.target() != null
        && message.arguments() != null) {
      return primary(message.target()) + "[" + values(message.arguments()) + "]";
    }
    return tree instanceof Ast.Declaration ? expression(tree) : primary(tree);
  }

  private static String declaration(Ast.Declaration declaration) {
    return (declaration.constant() ? "const var " : "var ")
        + target(declaration.target(), ".")
        + StringEscape.name(declaration.name())
        + (declaration.type() == null ? "" : " : " + primary(declaration.type()))
        + (declaration.value() == null ? "" : " = " + expression(declaration.value()));
  }

  private static String trajectory(Ast.Trajectory trajectory) {
    var text = new StringBuilder(lvalue(trajectory.target())).append(" =");
    if (trajectory.value() != null) {
      boolean greedy =
          trajectory.value() instanceof Ast.Assignment
              || trajectory.value() instanceof Ast.Trajectory;
      String value = expression(trajectory.value());
      text.append(greedy ? " (" + value + ")" : " " + value);
    }
    for (Ast.Modifier modifier : trajectory.modifiers()) {
      String value = disjunct(modifier.value());
      text.append(' ').append(StringEscape.name(modifier.name())).append(": ").append(value);
    }
    return text.toString();
  }

  private static String function(Ast.Function function) {
    String formals =
        function.formals() == null ? "" : Definitions.formals(function.formals()) + " ";
    String keyword = function.closure() ? "closure " : "function ";
    return keyword + formals + Statements.scope(function.body());
  }

  static String emission(Ast.Emit emit) {
    return primary(emit.event()) + "!" + arguments(emit.arguments());
  }
}
