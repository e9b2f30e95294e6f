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

/** Compiles {@code import}, and finds the receiver of a message without a target. */
final class ImplicitReceivers {
  private final Compilation compilation;

  ImplicitReceivers(Compilation compilation) {
    this.compilation = compilation;
  }

  private Symbol symbol(String name) {
    return compilation.interpreter().world().symbol(name);
  }

  /** The target of a message, or of an access to a slot. */
  Node target(@Nullable Ast target, String name, Span span, LexicalScope block) {
    if (target != null) {
      return compilation.operand(target, block);
    }
    Node receiver = implicit(name, span, block);
    return receiver == null ? new Literals.This(span) : receiver;
  }

  /**
   * The node that finds the receiver of a name without a target; null if that is always {@code
   * this}.
   */
  @Nullable Node implicit(String name, Span span, LexicalScope block) {
    List<Node> inner = new ArrayList<>();
    List<Node> outer = new ArrayList<>();
    boolean crossed = false;
    for (LexicalScope at = block; at != null; at = at.parent()) {
      for (LexicalScope.Import one : at.imports()) {
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

  Node importFrom(Ast.Import definition, LexicalScope block) {
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
    LocalVariable variable =
        compilation.declare(block, "<import " + span.begin() + ">", definition);
    Node code = new Imports.Local(source, name, compilation.place(variable, block));
    block.addImport(new LexicalScope.Import(variable, only));
    return code;
  }

  /**
   * The node of the path's first name, which it removes from the path if that has been resolved.
   */
  private Node root(List<String> path, @Nullable String only, Span span, LexicalScope block) {
    String first = path.getFirst();
    if (first.equals("this")) {
      path.removeFirst();
      return new Literals.This(span);
    }
    LocalVariable variable = block.find(first);
    if (variable != null && (only == null || path.size() > 1)) {
      path.removeFirst();
      return compilation.read(span, variable, block);
    }
    return new Imports.Root(span, target(null, first, span, block), symbol(first));
  }
}
