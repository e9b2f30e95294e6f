package org.urbi.lang.print;

import java.util.List;
import java.util.stream.Collectors;
import org.urbi.lang.ast.Ast;

/** Prints definitions of functions, classes and the like. */
final class Definitions {
  private Definitions() {}

  static String function(Ast.FunctionDefinition definition) {
    Ast.Function function = definition.function();
    String keyword = function.closure() ? "closure " : "function ";
    return keyword + named(definition.name(), function);
  }

  static String accessor(Ast.Accessor accessor) {
    String keyword = accessor.setter() ? "set " : "get ";
    return keyword + named(accessor.name(), accessor.function());
  }

  private static String named(Ast.Message name, Ast.Function function) {
    String formals = function.formals() == null ? "" : formals(function.formals());
    return Expressions.expression(name) + formals + " " + Statements.scope(function.body());
  }

  static String formals(List<Ast.Formal> formals) {
    return "(" + Expressions.join(formals, Definitions::formal) + ")";
  }

  private static String formal(Ast.Formal formal) {
    return "var "
        + StringEscape.name(formal.name())
        + (formal.variadic() ? "[]" : "")
        + (formal.type() == null ? "" : " : " + Expressions.primary(formal.type()))
        + (formal.defaultValue() == null
            ? ""
            : " = " + Expressions.expression(formal.defaultValue()));
  }

  static String classDefinition(Ast.ClassDefinition definition) {
    var text = new StringBuilder("class ").append(Expressions.expression(definition.name()));
    if (!definition.protos().isEmpty()) {
      text.append(": ").append(Expressions.values(definition.protos()));
    }
    if (definition.body() != null) {
      text.append('\n').append(Statements.block(definition.body()));
    }
    return text.toString();
  }

  static String packageDefinition(Ast.PackageDefinition definition) {
    String name = Expressions.expression(definition.name());
    return "package " + name + "\n" + Statements.block(definition.body());
  }

  static String enumDefinition(Ast.EnumDefinition definition) {
    return definition.values().stream()
        .map(value -> "\n  " + StringEscape.name(value) + ",")
        .collect(
            Collectors.joining(
                "", "enum " + Expressions.expression(definition.name()) + "\n{", "\n}"));
  }

  static String importStatement(Ast.Import statement) {
    String path =
        statement.path().stream()
            .map(name -> name.equals("this") ? name : StringEscape.name(name))
            .collect(Collectors.joining("."));
    return "import " + path + (statement.all() ? ".*" : "");
  }
}
