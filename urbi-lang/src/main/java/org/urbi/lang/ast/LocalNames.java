package org.urbi.lang.ast;

import java.util.ArrayList;
import java.util.List;
import org.urbi.lang.source.Span;

/** The variables that a statement declares in the surrounding scope. */
public final class LocalNames {
  private LocalNames() {}

  /** A name and its declaration. */
  public record Named(String name, Ast declaration, Span span) {}

  /** The names declared by a statement, or by a list of them, in their order. */
  public static List<Named> in(Ast statement) {
    // A chain of tests is fast here, because most statements declare nothing.
    if (statement instanceof Ast.Declaration declaration) {
      return declaration.target() == null
          ? List.of(new Named(declaration.name(), declaration, declaration.nameSpan()))
          : List.of();
    }
    if (statement instanceof Ast.FunctionDefinition definition) {
      return named(definition, definition.name());
    }
    if (statement instanceof Ast.ClassDefinition definition) {
      return named(definition, definition.name());
    }
    if (statement instanceof Ast.EnumDefinition definition) {
      return named(definition, definition.name());
    }
    if (statement instanceof Ast.Sequence sequence) {
      var all = new ArrayList<Named>();
      sequence.statements().forEach(each -> all.addAll(in(each)));
      return all;
    }
    return List.of();
  }

  private static List<Named> named(Ast definition, Ast.Message name) {
    return name.target() == null
        ? List.of(new Named(name.name(), definition, name.nameSpan()))
        : List.of();
  }
}
