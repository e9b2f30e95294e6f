package org.urbi.lang.print;

import java.util.List;
import org.urbi.lang.ast.Ast;

/** Prints definitions of functions, classes and the like. */
final class Definitions {
  private Definitions() {}

  static void function(Ast.FunctionDefinition definition, PrintedCode to) {
    to.add(definition.function().closure() ? "closure " : "function ");
    named(definition.name(), definition.function(), to);
  }

  static void accessor(Ast.Accessor accessor, PrintedCode to) {
    to.add(accessor.setter() ? "set " : "get ");
    named(accessor.name(), accessor.function(), to);
  }

  private static void named(Ast.Message name, Ast.Function function, PrintedCode to) {
    Expressions.message(name, to);
    if (function.formals() != null) {
      formals(function.formals(), to);
    }
    to.add(' ');
    Statements.scope(function.body(), to);
  }

  static void formals(List<Ast.Formal> formals, PrintedCode to) {
    to.add('(');
    for (int i = 0; i < formals.size(); i++) {
      if (i > 0) {
        to.add(", ");
      }
      formal(formals.get(i), to);
    }
    to.add(')');
  }

  private static void formal(Ast.Formal formal, PrintedCode to) {
    to.add("var ");
    to.name(formal.name());
    if (formal.variadic()) {
      to.add("[]");
    }
    if (formal.type() != null) {
      to.add(" : ");
      Expressions.primary(formal.type(), to);
    }
    if (formal.defaultValue() != null) {
      to.add(" = ");
      Expressions.expression(formal.defaultValue(), to);
    }
  }

  static void classDefinition(Ast.ClassDefinition definition, PrintedCode to) {
    to.add("class ");
    Expressions.message(definition.name(), to);
    if (!definition.protos().isEmpty()) {
      to.add(": ");
      Expressions.values(definition.protos(), to);
    }
    if (definition.body() != null) {
      to.line();
      Statements.block(definition.body(), to);
    }
  }

  static void packageDefinition(Ast.PackageDefinition definition, PrintedCode to) {
    to.add("package ");
    Expressions.message(definition.name(), to);
    to.line();
    Statements.block(definition.body(), to);
  }

  static void enumDefinition(Ast.EnumDefinition definition, PrintedCode to) {
    to.add("enum ");
    Expressions.message(definition.name(), to);
    to.line();
    to.add('{');
    to.more();
    for (String value : definition.values()) {
      to.line();
      to.name(value);
      to.add(',');
    }
    to.less();
    to.line();
    to.add('}');
  }

  static void importStatement(Ast.Import statement, PrintedCode to) {
    to.add("import ");
    List<String> path = statement.path();
    for (int i = 0; i < path.size(); i++) {
      if (i > 0) {
        to.add('.');
      }
      if (path.get(i).equals("this")) {
        to.add("this");
      } else {
        to.name(path.get(i));
      }
    }
    if (statement.all()) {
      to.add(".*");
    }
  }
}
