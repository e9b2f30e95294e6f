package org.urbi.kernel.uobject;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.variable.Datum;
import org.urbi.kernel.variable.UrbiUVar;
import org.urbi.lang.source.Span;
import urbi.UClass;
import urbi.UObject;

/**
 * Replaces the Java objects behind urbiscript objects by those of another version of their class.
 * The new ones are initialized with the same arguments, and their variables keep their values. If a
 * new one cannot be created, the old one stays.
 */
final class InstanceReplacement {
  private static final CallSite SITE =
      new CallSite() {
        @Override
        public String calledName() {
          return "loadModule";
        }

        @Override
        public @Nullable Span calledSpan() {
          return null;
        }
      };

  private final PluggedContext context;
  private final InstanceLifecycle creation;

  InstanceReplacement(PluggedContext context, InstanceLifecycle creation) {
    this.context = context;
    this.creation = creation;
  }

  /** The values of a variable before the replacement. */
  private record PreviousValues(Datum target, Datum sensed) {}

  /** The state of an object before the replacement. */
  private record PreviousInstance(
      UObject java,
      UClass type,
      Map<String, BoundFunction> functions,
      Map<UrbiUVar, PreviousValues> values) {
    /** Restores the values of the variables, and enables their notifications again. */
    void restore() {
      values.forEach((variable, known) -> {
        variable.restore(known.target, known.sensed);
        variable.silence(false);
      });
    }
  }

  /** Replaces the Java objects of all instances of the class. */
  void replace(Frame frame, UClass type) {
    for (Instance instance : context.objects().all()) {
      UObject java = instance.java();
      if (instance.type().name().equals(type.name()) && java != null) {
        UrbiObject object = instance.object();
        if (object != null) {
          replace(frame, instance, before(instance, java, object), object, type);
        }
      }
    }
  }

  private void replace(
      Frame frame, Instance instance, PreviousInstance before, UrbiObject object, UClass type) {
    before.values.keySet().forEach(variable -> variable.silence(true));
    instance.functions().clear();
    instance.setType(type);
    try {
      creation.create(frame, instance, type);
      if (instance.initArguments() != null) {
        creation.initialize(frame, SITE, instance, object, instance.initArguments());
      }
    } catch (RuntimeException | Error e) {
      undo(frame, instance, object, before);
      throw e;
    }
    for (String name : before.functions.keySet()) {
      if (!instance.functions().containsKey(name)) {
        object.removeSlot(creation.symbol(name));
      }
    }
    clean(frame, before.java);
    before.restore();
  }

  private static PreviousInstance before(Instance instance, UObject java, UrbiObject object) {
    Map<UrbiUVar, PreviousValues> values = new LinkedHashMap<>();
    for (Symbol slot : object.localSlotNames()) {
      UrbiUVar variable = UrbiUVar.behind(object, slot);
      if (variable != null) {
        values.put(variable, new PreviousValues(variable.target(), variable.visible()));
      }
    }
    return new PreviousInstance(
        java, instance.type(), new LinkedHashMap<>(instance.functions()), values);
  }

  private void undo(Frame frame, Instance instance, UrbiObject object, PreviousInstance before) {
    UObject failed = instance.java();
    for (String name : instance.functions().keySet()) {
      object.removeSlot(creation.symbol(name));
    }
    instance.functions().clear();
    instance.functions().putAll(before.functions);
    before.functions.forEach((name, function) -> creation.setSlot(object, name, function));
    instance.setJava(before.java);
    instance.setType(before.type);
    if (failed != null && failed != before.java) {
      clean(frame, failed);
    }
    before.restore();
  }

  private void clean(Frame frame, UObject java) {
    Frame outer = context.crossing().leave(frame, "clean of " + java.get__name());
    try {
      java.clean();
    } finally {
      context.crossing().back(frame, outer);
    }
  }
}
