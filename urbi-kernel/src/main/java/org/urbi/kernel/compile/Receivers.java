package org.urbi.kernel.compile;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Imports;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.Symbol;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.source.Span;

/** Compiles {@code import}, and finds who gets a message that has no target. */
final class Receivers {
  private final Compilation compilation;

  Receivers(Compilation compilation) {
    this.compilation = compilation;
  }

  private Symbol symbol(String name) {
    return compilation.interpreter().world().symbol(name);
  }

  /** The target of a message, or of an access to a slot. */
  Node target(@Nullable Ast target, String name, Span span, Block block) {
    if (target != null) {
      return compilation.operand(target, block);
    }
    Node receiver = implicit(name, span, block);
    return receiver == null ? new Literals.This(span) : receiver;
  }

  /** Who has a name without a target; null when it is {@code this} in any case. */
  @Nullable Node implicit(String name, Span span, Block block) {
    List<Node> inner = new ArrayList<>();
    List<Node> outer = new ArrayList<>();
    boolean crossed = false;
    for (Block at = block; at != null; at = at.parent()) {
      for (Block.Import one : at.imports()) {
        if (one.brings(name)) {
          (crossed ? outer : inner).add(compilation.read(span, one.variable(), block));
        }
      }
      crossed |= at.changesTarget() && at.parent() != null;
    }
    for (Imports.Imported one : compilation.imports().all().reversed()) {
      if (one.only() == null || one.only().equals(name)) {
        (crossed ? outer : inner).add(new Imports.Known(span, one.from()));
      }
    }
    return inner.isEmpty() && outer.isEmpty()
        ? null
        : new Imports.Receiver(span, symbol(name), inner, outer);
  }

  Node importFrom(Ast.Import definition, Block block) {
    List<String> path = new ArrayList<>(definition.path());
    String only = definition.all() ? null : path.getLast();
    Span span = definition.span();
    Node root = root(path, only, span, block);
    if (only != null && !path.isEmpty()) {
      path.removeLast();
    }
    Node source = new Imports.Source(span, root, path.stream().map(this::symbol).toList());
    Symbol name = only == null ? null : symbol(only);
    if (block.parent() == null) {
      return compilation.imports().new AtTop(source, name);
    }
    Variable variable = compilation.declare(block, "<import " + span.begin() + ">", definition);
    Node code = new Imports.Local(source, name, compilation.place(variable, block));
    block.addImport(new Block.Import(variable, only));
    return code;
  }

  /** Where the path begins, and takes its first name off if that is done with. */
  private Node root(List<String> path, @Nullable String only, Span span, Block block) {
    String first = path.getFirst();
    if (first.equals("this")) {
      path.removeFirst();
      return new Literals.This(span);
    }
    Variable variable = block.find(first);
    if (variable != null && (only == null || path.size() > 1)) {
      path.removeFirst();
      return compilation.read(span, variable, block);
    }
    return new Imports.Root(span, target(null, first, span, block), symbol(first));
  }
}
