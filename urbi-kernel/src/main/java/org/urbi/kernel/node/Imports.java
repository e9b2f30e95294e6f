package org.urbi.kernel.node;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * Packages and imports. A package is an object below {@code 'package'}. Up to the end of the
 * surrounding scope, {@code import a.b.*} looks names up in {@code a.b} that are not found
 * otherwise, and {@code import a.b} does so for the name {@code b} in {@code a}. Inner imports take
 * precedence.
 */
public final class Imports {
  /** An object from which names are imported at the top level, and the name if it is only one. */
  public record Imported(UrbiObject from, @Nullable String only) {}

  private final List<Imported> all = new ArrayList<>();

  /** The imports of earlier statements, oldest first. */
  public List<Imported> all() {
    return all;
  }

  /** The object that an {@code import} imports from. */
  public static final class Source extends Node {
    private final Node root;
    private final Symbol[] path;

    /**
     * @param root the object in which the first name is looked up
     * @param path the names to follow from there
     */
    public Source(Span span, Node root, List<Symbol> path) {
      super(span);
      this.root = root;
      this.path = path.toArray(Symbol[]::new);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject at = root.execute(frame);
      for (Symbol name : path) {
        at = member(frame, at, name, span());
      }
      return at;
    }
  }

  private static UrbiObject member(Frame frame, UrbiObject object, Symbol name, Span span) {
    UrbiObject found = SlotLookup.find(frame, object, name);
    if (found == null) {
      throw frame.located(frame.interpreter.errors().lookup(object, name.name()), span);
    }
    return found;
  }

  /** Finds the first name of an {@code import}: in the receiver, or among the packages. */
  public static final class Root extends Node {
    private final Node receiver;
    private final Symbol name;

    public Root(Span span, Node receiver, Symbol name) {
      super(span);
      this.receiver = receiver;
      this.name = name;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject object = receiver.execute(frame);
      return object.locate(name) == null ? packages(frame) : object;
    }
  }

  /** {@code import} at the top level: for the statements that follow. */
  public final class AtTop extends Node {
    private final Node source;
    private final @Nullable Symbol only;

    /**
     * @param only the only name that is imported, or null
     */
    public AtTop(Node source, @Nullable Symbol only) {
      super(source.span());
      this.source = source;
      this.only = only;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject from = source.execute(frame);
      if (only != null) {
        member(frame, from, only, span());
      }
      // Names that the lobby inherits are found without the import.
      if (only == null && frame.self.isA(from)) {
        return frame.interpreter.values().voidObject;
      }
      Imported one = new Imported(from, only == null ? null : only.name());
      all.remove(one);
      all.add(one);
      return frame.interpreter.values().voidObject;
    }
  }

  /** {@code import} in a scope. */
  public static final class Local extends Node {
    private final Node source;
    private final @Nullable Symbol only;
    private final Variables.Place place;

    /**
     * @param only the only name that is imported, or null
     * @param place the variable that holds the object for the code that follows
     */
    public Local(Node source, @Nullable Symbol only, Variables.Place place) {
      super(source.span());
      this.source = source;
      this.only = only;
      this.place = place;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject from = source.execute(frame);
      if (only != null) {
        member(frame, from, only, span());
      }
      place.declare(frame, from);
      return frame.interpreter.values().voidObject;
    }
  }

  /** An object from which an earlier statement has imported. */
  public static final class Known extends Node {
    private final UrbiObject object;

    public Known(Span span, UrbiObject object) {
      super(span);
      this.object = object;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      return object;
    }
  }

  /** Finds the receiver of a name without a target. */
  public static final class Receiver extends Node {
    private final Symbol name;
    private final Node[] inner;
    private final Node[] outer;

    /**
     * @param inner the imports of scopes with the same {@code this}, innermost first
     * @param outer the imports of the scopes around these
     */
    public Receiver(Span span, Symbol name, List<Node> inner, List<Node> outer) {
      super(span);
      this.name = name;
      this.inner = inner.toArray(Node[]::new);
      this.outer = outer.toArray(Node[]::new);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject found = among(frame, inner);
      if (found != null) {
        return found;
      }
      if (outer.length > 0 && frame.self.locate(name) == null) {
        found = among(frame, outer);
      }
      return found == null ? frame.self : found;
    }

    private @Nullable UrbiObject among(Frame frame, Node[] sources) {
      UrbiObject everybody = frame.interpreter.values().object;
      for (Node source : sources) {
        UrbiObject from = source.execute(frame);
        UrbiObject holder = from.locate(name);
        // Slots that every object has are not imported.
        if (holder != null && (holder == from || !everybody.isA(holder))) {
          return from;
        }
      }
      return null;
    }
  }

  /** {@code package name}: the package of that name, which is created if it does not exist. */
  public static final class Package extends Node {
    private final Symbol[] path;

    public Package(Span span, List<Symbol> path) {
      super(span);
      this.path = path.toArray(Symbol[]::new);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      // A package declared inside a package becomes a part of it.
      UrbiObject at = frame.self instanceof UrbiPackage ? frame.self : packages(frame);
      for (Symbol name : path) {
        UrbiObject known = at.localSlot(name);
        if (known == null) {
          known = new UrbiPackage(frame.interpreter.values().object.cloneShape());
          ClassNodes.nameType(frame.interpreter, known, name.name());
          at.addSlot(name, known);
        }
        at = known;
      }
      return at;
    }
  }

  /** A package; a clone of one is an ordinary object. */
  private static final class UrbiPackage extends UrbiObject {
    UrbiPackage(Shape shape) {
      super(shape);
    }
  }

  private static UrbiObject packages(Frame frame) {
    return frame.interpreter.world().prototype("package");
  }
}
