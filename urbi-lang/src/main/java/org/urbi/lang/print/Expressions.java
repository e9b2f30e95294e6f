package org.urbi.lang.print;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;

/** Prints expressions. */
final class Expressions {
  private Expressions() {}

  /** An expression of any precedence; a statement goes between braces. */
  static void expression(Ast tree, PrintedCode to) {
    if (tree instanceof Ast.Message message) {
      message(message, to);
    } else if (Binding.of(tree) == Binding.STATEMENT) {
      Statements.clause(tree, to);
    } else {
      tree.accept(to);
    }
  }

  /** What binds at least as tight as a message. */
  static void primary(Ast tree, PrintedCode to) {
    if (tree instanceof Ast.Message message) {
      message(message, to);
      return;
    }
    Binding binding = Binding.of(tree);
    if (binding == Binding.STATEMENT) {
      Statements.clause(tree, to);
    } else if (binding == Binding.TIGHT) {
      tree.accept(to);
    } else {
      to.add('(');
      tree.accept(to);
      to.add(')');
    }
  }

  static void list(List<Ast> elements, PrintedCode to) {
    to.add('[');
    values(elements, to);
    to.add(']');
  }

  static void and(Ast.And and, PrintedCode to) {
    conjunct(and.left(), to);
    to.add(" && ");
    primary(and.right(), to);
  }

  static void or(Ast.Or or, PrintedCode to) {
    disjunct(or.left(), to);
    to.add(" || ");
    conjunct(or.right(), to);
  }

  private static void conjunct(Ast tree, PrintedCode to) {
    if (tree instanceof Ast.And) {
      tree.accept(to);
    } else {
      primary(tree, to);
    }
  }

  private static void disjunct(Ast tree, PrintedCode to) {
    if (tree instanceof Ast.Or) {
      tree.accept(to);
    } else {
      conjunct(tree, to);
    }
  }

  static void slot(Ast.SlotAccess slot, PrintedCode to) {
    target(slot.target(), to);
    to.add('&');
    to.name(slot.name());
  }

  static void property(Ast.Property property, PrintedCode to) {
    target(property.target(), to);
    to.name(property.slot());
    to.add("->");
    to.name(property.name());
  }

  static void assign(Ast target, String operator, Ast value, PrintedCode to) {
    lvalue(target, to);
    to.add(' ');
    to.add(operator);
    to.add(' ');
    expression(value, to);
  }

  static void postfix(Ast.Postfix postfix, PrintedCode to) {
    lvalue(postfix.target(), to);
    to.add(postfix.operator());
  }

  static void watch(Ast.Watch watch, PrintedCode to) {
    to.add("watch(");
    expression(watch.expression(), to);
    to.add(')');
  }

  static void values(List<Ast> values, PrintedCode to) {
    for (int i = 0; i < values.size(); i++) {
      if (i > 0) {
        to.add(", ");
      }
      expression(values.get(i), to);
    }
  }

  static void arguments(@Nullable List<Ast> arguments, PrintedCode to) {
    if (arguments != null) {
      to.add('(');
      values(arguments, to);
      to.add(')');
    }
  }

  static void tuple(List<Ast> elements, PrintedCode to) {
    to.add('(');
    values(elements, to);
    to.add(elements.size() == 1 ? ",)" : ")");
  }

  static void dictionary(List<Ast.Entry> entries, PrintedCode to) {
    if (entries.isEmpty()) {
      to.add("[ => ]");
      return;
    }
    to.add('[');
    to.more();
    for (int i = 0; i < entries.size(); i++) {
      to.line();
      expression(entries.get(i).key(), to);
      to.add(" => ");
      expression(entries.get(i).value(), to);
      to.add(',');
    }
    to.less();
    to.line();
    to.add(']');
  }

  static void message(Ast.Message message, PrintedCode to) {
    if (message.target() instanceof Ast.Message) {
      chain(message, to);
    } else {
      target(message.target(), to);
      call(message, to);
    }
  }

  /** Chains are longer than anything else: they are followed without recursion. */
  private static void chain(Ast.Message last, PrintedCode to) {
    int length = 0;
    Ast target = last;
    while (target instanceof Ast.Message link) {
      length++;
      target = link.target();
    }
    var chain = new Ast.Message[length];
    Ast next = last;
    while (next instanceof Ast.Message link) {
      length--;
      chain[length] = link;
      next = link.target();
    }
    target(target, to);
    for (int i = 0; i < chain.length; i++) {
      if (i > 0) {
        to.add('.');
      }
      call(chain[i], to);
    }
  }

  /** A message without its target. */
  private static void call(Ast.Message message, PrintedCode to) {
    to.name(message.name());
    arguments(message.arguments(), to);
  }

  /** What a message is sent to, and what separates them; nothing for an implicit target. */
  private static void target(@Nullable Ast tree, PrintedCode to) {
    if (tree != null) {
      primary(tree, to);
      to.add('.');
    }
  }

  /** What may be assigned to: a subscript is written as one there. */
  static void lvalue(Ast tree, PrintedCode to) {
    if (tree instanceof Ast.Message message
        && message.target() != null
        && message.arguments() != null
        && message.name().equals("[]")) {
      primary(message.target(), to);
      list(message.arguments(), to);
    } else if (tree instanceof Ast.Declaration) {
      tree.accept(to);
    } else {
      primary(tree, to);
    }
  }

  static void declaration(Ast.Declaration declaration, PrintedCode to) {
    to.add(declaration.constant() ? "const var " : "var ");
    target(declaration.target(), to);
    to.name(declaration.name());
    if (declaration.type() != null) {
      to.add(" : ");
      primary(declaration.type(), to);
    }
    if (declaration.value() != null) {
      to.add(" = ");
      expression(declaration.value(), to);
    }
  }

  static void trajectory(Ast.Trajectory trajectory, PrintedCode to) {
    lvalue(trajectory.target(), to);
    to.add(" =");
    Ast value = trajectory.value();
    if (value instanceof Ast.Assignment || value instanceof Ast.Trajectory) {
      // It would take the modifiers for its own.
      to.add(" (");
      value.accept(to);
      to.add(')');
    } else if (value != null) {
      to.add(' ');
      expression(value, to);
    }
    for (Ast.Modifier modifier : trajectory.modifiers()) {
      to.add(' ');
      to.name(modifier.name());
      to.add(": ");
      disjunct(modifier.value(), to);
    }
  }

  static void function(Ast.Function function, PrintedCode to) {
    to.add(function.closure() ? "closure " : "function ");
    if (function.formals() != null) {
      Definitions.formals(function.formals(), to);
      to.add(' ');
    }
    Statements.scope(function.body(), to);
  }
}
