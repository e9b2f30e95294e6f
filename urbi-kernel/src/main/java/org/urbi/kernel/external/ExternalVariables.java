package org.urbi.kernel.external;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.uobject.PluggedContext;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UCallback;
import urbi.USlot;
import urbi.UValue;

/**
 * The variables to which an external process has subscribed: it is sent each new value, except
 * those it has set itself.
 */
public final class ExternalVariables {
  private static final int ASSIGN = 1;
  private static final double SECOND = 1e9;

  private static final MethodHandle CHANGED;

  static {
    try {
      CHANGED =
          MethodHandles.lookup()
              .findVirtual(
                  Binding.class, "changed", MethodType.methodType(void.class, UValue.class));
    } catch (ReflectiveOperationException e) {
      throw new ExceptionInInitializerError(e);
    }
  }

  /** A variable of the process, with the number of its subscriptions. */
  private final class Binding {
    private final String name;
    private final USlot slot;
    private int uses;

    Binding(String name) {
      this.name = name;
      this.slot = context.variable(name);
      slot.onChange(null, UCallback.of(name, CHANGED.bindTo(this)));
    }

    void changed(UValue value) {
      boolean own = beingSet == PluggedContext.behind(slot) && scheduler.running() == setter;
      if (!own && !value.isVoid()) {
        StringBuilder text = process.message(ASSIGN, name);
        ValueText.append(text.append(", "), value);
        process.send(
            text.append(", ").append(String.format(Locale.ROOT, "%.6f", scheduler.now() / SECOND)));
      }
    }
  }

  private final ExternalProcess process;
  private final Scheduler scheduler;
  private final PluggedContext context;
  private final Map<String, Binding> bindings = new HashMap<>();
  private @Nullable UrbiUVar beingSet;
  private @Nullable Job setter;

  ExternalVariables(ExternalProcess process, Scheduler scheduler, PluggedContext context) {
    this.process = process;
    this.scheduler = scheduler;
    this.context = context;
  }

  /**
   * {@code external var}: the process subscribes to the changes of a variable, which is created if
   * it does not exist.
   *
   * @throws IllegalArgumentException if there is no such object
   */
  public void use(String name) {
    if (!process.isRefused(name)) {
      bindings.computeIfAbsent(name, Binding::new).uses++;
    }
  }

  /** {@code unnotify}: ends that number of subscriptions to the variable. */
  void unuse(String name, double times) {
    Binding binding = bindings.get(name);
    if (binding != null) {
      binding.uses -= (int) times;
      if (binding.uses <= 0) {
        bindings.remove(name);
        binding.slot.close();
      }
    }
  }

  /** The process sets a variable. */
  void assign(Frame frame, String name, UValue value) {
    Binding binding = bindings.get(name);
    USlot slot = binding == null ? process.access().variable(frame, name) : binding.slot;
    if (slot == null) {
      throw new IllegalArgumentException(Problem.NO_VARIABLE.text(name));
    }
    set(PluggedContext.behind(slot), () -> slot.set(value));
  }

  /** Sets a variable on behalf of the process, without sending the value back to it. */
  public void set(UrbiUVar variable, Runnable writing) {
    UrbiUVar outer = beingSet;
    Job outerSetter = setter;
    beingSet = variable;
    setter = scheduler.running();
    try {
      writing.run();
    } finally {
      beingSet = outer;
      setter = outerSetter;
    }
  }

  /** Forgets the variables of an object that no longer exists. */
  void forget(String object) {
    List.copyOf(bindings.keySet()).stream()
        .filter(name -> name.lastIndexOf('.') == object.length() && name.startsWith(object))
        .forEach(name -> bindings.remove(name).slot.close());
  }

  void clear() {
    bindings.values().forEach(binding -> binding.slot.close());
    bindings.clear();
  }
}
