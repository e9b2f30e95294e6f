package org.urbi.kernel.node;

import java.util.List;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Pseudo classes and enumerations. */
public final class ClassNodes {
  private ClassNodes() {}

  /** Gives an object the slots that tell its type: {@code type} and {@code asType}. */
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
        parents[i] = ArgumentEvaluation.notVoid(frame, protos[i], span());
        if (parents[i].isA(interpreter.world().prototype("Finalizable"))) {
          UrbiException refused = interpreter.errors().finalizable("apply");
          refused.locate(null, frame.backtrace());
          throw refused;
        }
      }
      UrbiObject first = parents.length == 0 ? interpreter.values().object : parents[0];
      UrbiObject object = first.cloned();
      if (parents.length > 1) {
        object.setProtos(parents);
      }
      nameType(interpreter, object, name);
      PermissionCheck.claimForObserver(frame, object);
      return object;
    }
  }

  /** The declaration of an object, followed by its body, which is evaluated on it. */
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
      try {
        return interpreter.send(
            frame, interpreter.prototypes.enumeration, "new", values.string(name), names);
      } catch (UrbiException e) {
        throw frame.located(e, span());
      }
    }
  }
}
