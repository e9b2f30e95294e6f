package org.urbi.kernel.compile;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.ClassNodes;
import org.urbi.kernel.node.Imports;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Properties;
import org.urbi.kernel.node.Slots;
import org.urbi.kernel.node.Variables;
import org.urbi.kernel.object.Symbol;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.source.Span;

/** Compiles definitions: variables, functions, classes, enumerations, packages. */
final class Definitions {
  private final Compilation compilation;

  Definitions(Compilation compilation) {
    this.compilation = compilation;
  }

  private Interpreter interpreter() {
    return compilation.interpreter();
  }

  private Symbol symbol(String name) {
    return interpreter().world().symbol(name);
  }

  private Node target(@Nullable Ast target, Span span, LexicalScope block) {
    return compilation.expressions.target(target, span, block);
  }

  Node declaration(Ast.Declaration declaration, LexicalScope block) {
    Span span = declaration.span();
    // The value is compiled before the name is declared: var x = x + 1 reads an outer x.
    Node value = compilation.optional(declaration.value(), block);
    Node type = compilation.optional(declaration.type(), block);
    if (declaration.target() != null || block.declaresSlots()) {
      return new Slots.Declare(
          span,
          declaration.nameSpan(),
          target(declaration.target(), span, block),
          symbol(declaration.name()),
          value,
          declaration.constant(),
          type);
    }
    return new Variables.Declare(
        declaration.nameSpan(),
        declaration.name(),
        declare(block, declaration.name(), declaration),
        value,
        type);
  }

  private Variables.Place declare(LexicalScope block, String name, Ast key) {
    LocalVariable begun = block.begun(key);
    return begun == null
        ? compilation.place(compilation.declare(block, name, key), block)
        : compilation.placeBegun(begun, block);
  }

  /** Binds a value to a name: a slot or a local variable. */
  private Node named(Ast.Message name, Ast key, Span span, LexicalScope block, Node value) {
    if (name.target() != null || block.declaresSlots()) {
      return new Slots.Declare(
          span,
          name.nameSpan(),
          target(name.target(), span, block),
          symbol(name.name()),
          value,
          false,
          null);
    }
    return new Variables.Declare(span, name.name(), declare(block, name.name(), key), value, null);
  }

  Node function(Ast.FunctionDefinition definition, LexicalScope block) {
    Ast.Message name = definition.name();
    Span span = definition.span();
    if (name.target() != null || block.declaresSlots()) {
      return named(
          name,
          definition,
          span,
          block,
          compilation.functions.compile(definition.function(), block));
    }
    // A local function can call itself, so its name is declared before its body is compiled.
    Variables.Place place = declare(block, name.name(), definition);
    Node function = compilation.functions.compile(definition.function(), block);
    return new Variables.DeclareRecursive(span, place, function);
  }

  Node classDefinition(Ast.ClassDefinition definition, LexicalScope block) {
    Node[] protos = compilation.all(definition.protos(), block);
    Node object =
        new ClassNodes.New(definition.span(), protos, interpreter(), definition.name().name());
    return withBody(definition.name(), definition, definition.body(), block, object);
  }

  Node packageDefinition(Ast.PackageDefinition definition, LexicalScope block) {
    Span span = definition.span();
    List<Symbol> path = new ArrayList<>();
    for (Ast at = definition.name(); at instanceof Ast.Message name; at = name.target()) {
      path.addFirst(symbol(name.name()));
    }
    return new ClassNodes.WithBody(
        span,
        new Imports.Package(span, path),
        compilation.statements.scopeIn(definition.body(), block.target(), HandledJumps.NOTHING));
  }

  private Node withBody(
      Ast.Message name, Ast key, Ast.@Nullable Scope body, LexicalScope block, Node object) {
    Node declared = named(name, key, key.span(), block, object);
    if (body == null) {
      return declared;
    }
    return new ClassNodes.WithBody(
        key.span(),
        declared,
        compilation.statements.scopeIn(body, block.target(), HandledJumps.NOTHING));
  }

  Node enumDefinition(Ast.EnumDefinition definition, LexicalScope block) {
    Ast.Message name = definition.name();
    Node object =
        new ClassNodes.Enumeration(
            definition.span(), interpreter(), name.name(), List.copyOf(definition.values()));
    return named(name, definition, definition.span(), block, object);
  }

  Node accessor(Ast.Accessor accessor, LexicalScope block) {
    Ast.Message name = accessor.name();
    return new Properties.Accessor(
        accessor.span(),
        target(name.target(), accessor.span(), block),
        symbol(name.name()),
        accessor.setter(),
        compilation.functions.compile(accessor.function(), block));
  }
}
