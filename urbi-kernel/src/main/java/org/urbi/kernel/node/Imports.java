package org.urbi.kernel.node;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/**
 * Packages and imports. A package is an object below {@code 'package'}. {@code import a.b.*} has
 * names that are nobody's looked up in {@code a.b}, {@code import a.b} the name {@code b} in {@code
 * a}, to the end of the scope around; what is further inside goes first.
 */
public final class Imports {
  /** An object that names are imported from at the top level, and the only name if it is one. */
  public record Imported(UrbiObject from, @Nullable String only) {}

  private final List<Imported> all = new ArrayList<>();

  /** What the statements before have imported, oldest first. */
  public List<Imported> all() {
    return all;
  }

  /** The object that an {@code import} imports from. */
  public static final class Source extends Node {
    private final Node root;
    private final Symbol[] path;

    /**
     * @param root what the first name is looked up in
     * @param path the names of the objects on the way
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

  /** Where the first name of an {@code import} is: with the receiver, or among the packages. */
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
      // What the lobby inherits from is known anyway.
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
     * @param place where the object is kept for the code that follows
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

  /** An object that was imported from before. */
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

  /** Who has a name that was written without a target. */
  public static final class Receiver extends Node {
    private final Symbol name;
    private final Node[] inner;
    private final Node[] outer;

    /**
     * @param inner what is imported where {@code this} is the same, the innermost first
     * @param outer what is imported around that
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
        // What every object has is not imported.
        if (holder != null && (holder == from || !everybody.isA(holder))) {
          return from;
        }
      }
      return null;
    }
  }

  /** {@code package name}: the package of that name, made when it is not there. */
  public static final class Package extends Node {
    private final Symbol[] path;

    public Package(Span span, List<Symbol> path) {
      super(span);
      this.path = path.toArray(Symbol[]::new);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      // A package in a package is a part of it.
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
