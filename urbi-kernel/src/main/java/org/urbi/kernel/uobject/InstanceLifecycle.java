package org.urbi.kernel.uobject;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.ClassNodes;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.World;
import urbi.UCallback;
import urbi.UClass;
import urbi.UObject;

/**
 * Creates and ends UObjects: pairs of an urbiscript object and a Java object (manual, "Creating new
 * instances"). Used on the kernel thread.
 */
public final class InstanceLifecycle {
  private final PluggedContext context;
  private final Interpreter interpreter;
  private final World world;
  private final InstanceReplacement replacement;

  /** The prototype object of each class, which exists as long as the class. */
  private final Map<String, UrbiObject> prototypes = new LinkedHashMap<>();

  /** Objects whose Java object is being created. */
  private final Map<String, Instance> pending = new LinkedHashMap<>();

  InstanceLifecycle(PluggedContext context) {
    this.context = context;
    this.interpreter = context.interpreter();
    this.world = interpreter.world();
    this.replacement = new InstanceReplacement(context, this);
  }

  private Instances objects() {
    return context.objects();
  }

  // ------------------------------------------------------------------ classes

  /**
   * Registers a class. If one of that name exists, the Java objects behind its urbiscript objects
   * are replaced.
   *
   * @return the action that publishes it
   */
  Runnable start(Frame frame, UClass type) {
    if (prototypes.containsKey(type.name())) {
      replacement.replace(frame, type);
      return () -> {};
    }
    UrbiObject prototype = world.prototype("UObject").cloned();
    ClassNodes.nameType(interpreter, prototype, Utf8Text.toUrbi(type.name()));
    Instance instance = objects().add(type.name(), type, prototype, frame.job().lobby());
    prototypes.put(type.name(), prototype);
    try {
      create(frame, instance, type);
    } catch (RuntimeException | Error e) {
      prototypes.remove(type.name());
      end(frame, instance);
      throw e;
    }
    return () -> objects().publishClass(instance);
  }

  /** Ends a class with all its objects, which stay in urbiscript without their functions. */
  void endClass(Frame frame, UClass type) {
    for (Instance instance : objects().all()) {
      if (instance.type() == type) {
        UrbiObject object = instance.object();
        end(frame, instance);
        if (object != null) {
          instance.functions().keySet().forEach(name -> object.removeSlot(symbol(name)));
        }
      }
    }
    prototypes.remove(type.name());
  }

  // ------------------------------------------------------------------ objects

  /** {@code new}: an object of the class of that prototype, initialized with these arguments. */
  public UrbiObject make(
      Frame frame, CallSite site, UrbiObject prototype, UrbiObject... arguments) {
    UrbiObject made = prototype.cloned();
    Instance parent = objects().nearest(prototype);
    if (parent == null) {
      interpreter.send(frame, site, made, interpreter.symbols().init, arguments);
      return made;
    }
    Instance instance = add(parent.type(), made, frame);
    try {
      create(frame, instance, parent.type());
      objects().publish(instance);
      initialize(frame, site, instance, made, arguments);
    } catch (RuntimeException | Error e) {
      end(frame, instance);
      throw e;
    }
    return made;
  }

  private Instance add(UClass type, UrbiObject object, Frame frame) {
    String name = type.name() + "_0x" + Long.toHexString(object.uid());
    return objects().add(name, type, object, frame.job().lobby());
  }

  /** Calls {@code init}, and checks its result. */
  void initialize(
      Frame frame, CallSite site, Instance instance, UrbiObject object, UrbiObject... arguments) {
    Symbol init = interpreter.symbols().init;
    UrbiObject result = interpreter.send(frame, site, object, init, arguments);
    instance.setInitArguments(arguments);
    boolean bound = object.lookup(init) instanceof BoundFunction;
    if (bound && result instanceof UrbiFloat status && status.value() != 0) {
      throw interpreter
          .errors()
          .primitive(
              site.calledName(),
              Problem.CONSTRUCTION_FAILED,
              Utf8Text.toUrbi(instance.type().name()),
              interpreter.asString(frame, status));
    }
  }

  /** Creates the Java object. */
  void create(Frame frame, Instance instance, UClass type) {
    pending.put(instance.name(), instance);
    try {
      construct(frame, instance.object(), instance.name(), () -> type.create(instance.name()));
    } finally {
      pending.remove(instance.name());
    }
  }

  /**
   * Runs a constructor.
   *
   * @param object what it is in urbiscript; null if it is nothing there
   */
  <T> T construct(Frame frame, @Nullable UrbiObject object, String name, Callable<T> constructor) {
    Frame outer = context.crossing().leave(frame, object, "the constructor of " + name);
    try {
      return constructor.call();
    } catch (Throwable e) {
      throw switch (e) {
        case ControlFlowException unwinding -> unwinding;
        case UrbiException thrown -> thrown;
        case PropagatedUrbiException raised -> raised.original();
        default ->
            interpreter
                .errors()
                .primitive(
                    Utf8Text.toUrbi(name),
                    Problem.REASON,
                    Utf8Text.toUrbi(caught("constructing " + name, e)));
      };
    } finally {
      context.crossing().back(frame, outer);
    }
  }

  private static String caught(String doing, Throwable e) {
    String told = JavaFailures.caught(doing, e);
    return e instanceof NoClassDefFoundError && e.getMessage() != null
        ? Problem.CAUGHT_IN_COMPONENT.text(
            doing, Problem.MISSING_CLASS.text(e.getMessage().replace('/', '.')))
        : told;
  }

  /**
   * Connects a Java object that is being constructed with an urbiscript object, which is created if
   * needed.
   */
  String attach(Frame frame, UObject object, @Nullable String name) {
    Instance instance = name == null ? null : pending.get(name);
    if (instance == null) {
      UClass type = object.getUClass();
      UrbiObject prototype = prototypes.getOrDefault(type.name(), world.prototype("UObject"));
      instance = add(type, prototype.cloned(), frame);
      instance.keepAlive(true);
      objects().publish(instance);
    }
    instance.setJava(object);
    return instance.name();
  }

  /** Disconnects a Java object. */
  void detach(UObject object) {
    context.periods().end(object);
    Instance instance = objects().named(object.get__name());
    if (instance != null && instance.java() == object) {
      forget(instance);
    }
  }

  private void forget(Instance instance) {
    objects().remove(instance);
    instance.keepAlive(false);
    instance
        .functions()
        .values()
        .forEach(function -> {
          function.end(why(instance.java()));
          context.statistics().forget(function.callback().name());
        });
  }

  private static String why(@Nullable UObject java) {
    String why = java instanceof Reclaimable perishable ? perishable.reclaimReason() : null;
    return why == null ? Problem.OBJECT_DESTROYED.text() : why;
  }

  /** Ends an object: notifies the Java object, and removes its name. */
  public void end(Frame frame, Instance instance) {
    UObject java = instance.java();
    if (java == null) {
      forget(instance);
      return;
    }
    Frame outer = context.crossing().leave(frame, "clean of " + instance.name());
    try {
      java.clean();
    } finally {
      context.crossing().back(frame, outer);
    }
  }

  /** {@code destroy}: ends a UObject; false if the object is none. */
  public boolean destroy(Frame frame, UrbiObject object) {
    Instance instance = objects().of(object);
    if (instance == null) {
      return false;
    }
    end(frame, instance);
    return true;
  }

  // ------------------------------------------------------------------ functions

  /** Makes a function a slot of the urbiscript object. */
  void bind(UObject object, String name, UCallback callback) {
    Instance instance = objects().named(object.get__name());
    if (instance == null || instance.object() == null) {
      throw new IllegalStateException(Problem.DESTROYED.text(object.get__name()));
    }
    var function = new BoundFunction(world.prototype("Code").cloneShape(), context, callback);
    instance.functions().put(name, function);
    setSlot(instance.object(), name, function);
  }

  void setSlot(UrbiObject object, String name, UrbiObject value) {
    object.removeSlot(symbol(name));
    object.addSlot(symbol(name), value);
  }

  Symbol symbol(String name) {
    return world.symbol(Utf8Text.toUrbi(name));
  }

  // ------------------------------------------------------------------ the end

  /** The kernel has ended: notifies all Java objects. */
  void close() {
    for (Instance instance : objects().all()) {
      if (instance.java() != null) {
        instance.java().clean();
      }
    }
  }
}
