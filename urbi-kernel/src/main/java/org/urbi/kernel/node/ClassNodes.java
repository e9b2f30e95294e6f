package org.urbi.kernel.node;

import java.util.List;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Pseudo classes, enumerations, packages. */
public final class ClassNodes {
  private ClassNodes() {}

  /** Gives an object the slots by which its type is known: {@code type} and {@code asType}. */
  public static void nameType(Interpreter interpreter, UrbiObject object, String name) {
    var world = interpreter.world();
    object.addSlot(world.symbol("type"), interpreter.values().string(name));
    object.addSlot(world.symbol("as" + name), interpreter.prototypes.asThis);
  }

  /** The object of {@code class Name : protos}. */
  public static final class New extends Node {
    private final Node[] protos;
    private final Interpreter interpreter;
    private final String name;

    public New(Span span, Node[] protos, Interpreter interpreter, String name) {
      super(span);
      this.protos = protos;
      this.interpreter = interpreter;
      this.name = name;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject[] parents = new UrbiObject[protos.length];
      for (int i = 0; i < parents.length; i++) {
        parents[i] = Arguments.notVoid(frame, protos[i], span());
      }
      UrbiObject first = parents.length == 0 ? interpreter.values().object : parents[0];
      UrbiObject object = first.cloned();
      if (parents.length > 1) {
        object.setProtos(parents);
      }
      nameType(interpreter, object, name);
      return object;
    }
  }

  /** An object that has been declared, and the body evaluated on it. */
  public static final class WithBody extends Node {
    private final Node declaration;
    private final Node body;

    public WithBody(Span span, Node declaration, Node body) {
      super(span);
      this.declaration = declaration;
      this.body = body;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject object = declaration.execute(frame);
      Frame inner = frame.withSelf(object);
      inner.background = frame.background;
      body.execute(inner);
      return object;
    }
  }

  /** {@code package name}: the object of that name, made when it is not there. */
  public static final class Package extends Node {
    private final Node target;
    private final Symbol name;

    public Package(Span span, Node target, Interpreter interpreter, String name) {
      super(span);
      this.target = target;
      this.name = interpreter.world().symbol(name);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject owner = target.execute(frame);
      UrbiObject known = owner.lookup(name);
      if (known == null) {
        known = frame.interpreter.values().object.cloned();
        nameType(frame.interpreter, known, name.name());
        owner.addSlot(name, known);
      }
      return known;
    }
  }

  /** {@code import a.b.c}: makes it known by its last name; {@code a.b.*} all that it has. */
  public static final class Import extends Node {
    private final Symbol[] path;
    private final boolean all;

    public Import(Span span, Interpreter interpreter, List<String> path, boolean all) {
      super(span);
      this.path = path.stream().map(interpreter.world()::symbol).toArray(Symbol[]::new);
      this.all = all;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject at = frame.self;
      for (Symbol name : path) {
        UrbiObject next = SlotLookup.find(frame, at, name);
        if (next == null) {
          throw frame.located(frame.interpreter.errors().lookup(at, name.name()), span());
        }
        at = next;
      }
      if (all) {
        for (Symbol name : at.localSlotNames()) {
          define(frame, name, at.localSlot(name));
        }
      } else {
        define(frame, path[path.length - 1], at);
      }
      return frame.interpreter.values().voidObject;
    }

    private static void define(Frame frame, Symbol name, UrbiObject value) {
      if (frame.self.localSlot(name) == null) {
        frame.self.addSlot(name, value);
      }
    }
  }

  /** {@code enum Name { a, b }}. */
  public static final class Enumeration extends Node {
    private final Interpreter interpreter;
    private final String name;
    private final List<String> members;

    public Enumeration(Span span, Interpreter interpreter, String name, List<String> members) {
      super(span);
      this.interpreter = interpreter;
      this.name = name;
      this.members = members;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      var values = interpreter.values();
      UrbiObject names = values.list(members.stream().map(values::string).toList());
      return interpreter.send(
          frame, interpreter.prototypes.enumeration, "new", values.string(name), names);
    }
  }
}
