package org.urbi.lang.print;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;

/** Prints expressions. */
final class Expressions {
  private Expressions() {}

  /** An expression of any precedence; a statement goes between braces. */
  static String expression(Ast tree) {
    NodePrinters.Form form = NodePrinters.of(tree);
    return form.binding() == NodePrinters.Binding.STATEMENT
        ? Statements.clause(tree)
        : form.text().get();
  }

  static String list(List<Ast> elements) {
    return "[" + values(elements) + "]";
  }

  static String and(Ast.And and) {
    return conjunct(and.left()) + " && " + primary(and.right());
  }

  static String or(Ast.Or or) {
    return disjunct(or.left()) + " || " + conjunct(or.right());
  }

  static String slot(Ast.SlotAccess slot) {
    return target(slot.target(), ".") + "&" + StringEscape.name(slot.name());
  }

  static String property(Ast.Property property) {
    return target(property.target(), ".")
        + StringEscape.name(property.slot())
        + "->"
        + StringEscape.name(property.name());
  }

  static String assign(Ast target, String operator, Ast value) {
    return lvalue(target) + " " + operator + " " + expression(value);
  }

  static String watch(Ast.Watch watch) {
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

  static String tuple(List<Ast> elements) {
    return "(" + values(elements) + (elements.size() == 1 ? ",)" : ")");
  }

  static String dictionary(List<Ast.Entry> entries) {
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

  static String message(Ast.Message message) {
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
    boolean loose = NodePrinters.of(tree).binding() == NodePrinters.Binding.LOOSE;
    return loose ? "(" + expression(tree) + ")" : expression(tree);
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

  static String declaration(Ast.Declaration declaration) {
    return (declaration.constant() ? "const var " : "var ")
        + target(declaration.target(), ".")
        + StringEscape.name(declaration.name())
        + (declaration.type() == null ? "" : " : " + primary(declaration.type()))
        + (declaration.value() == null ? "" : " = " + expression(declaration.value()));
  }

  static String trajectory(Ast.Trajectory trajectory) {
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

  static String function(Ast.Function function) {
    String formals =
        function.formals() == null ? "" : Definitions.formals(function.formals()) + " ";
    String keyword = function.closure() ? "closure " : "function ";
    return keyword + formals + Statements.scope(function.body());
  }

  static String emission(Ast.Emit emit) {
    return primary(emit.event()) + "!" + arguments(emit.arguments());
  }
}
