package org.urbi.kernel.variable;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** All variables of a kernel, as far as they are still used. On the kernel thread. */
public final class KnownVariables implements UrbiObject.Companion {
  private static final int FEW = 64;

  private final List<WeakReference<UrbiUVar>> all = new ArrayList<>(0);
  private final List<Consumer<UrbiUVar>> listeners = new ArrayList<>(0);
  private int tidyAt = FEW;

  /** Those of that kernel; the prototype of all variables keeps them. */
  public static KnownVariables of(World world) {
    UrbiObject prototype = world.prototype("UVar");
    if (prototype.companion() instanceof KnownVariables known) {
      return known;
    }
    KnownVariables made = new KnownVariables();
    prototype.setCompanion(made);
    return made;
  }

  void add(UrbiUVar variable) {
    if (all.size() >= tidyAt) {
      all.removeIf(reference -> reference.refersTo(null));
      tidyAt = Math.max(FEW, 2 * all.size());
    }
    all.add(new WeakReference<>(variable));
    List.copyOf(listeners).forEach(listener -> listener.accept(variable));
  }

  /** All of them, in the order in which they were made. */
  public List<UrbiUVar> all() {
    List<UrbiUVar> variables = new ArrayList<>(all.size());
    for (WeakReference<UrbiUVar> reference : all) {
      UrbiUVar variable = reference.get();
      if (variable != null) {
        variables.add(variable);
      }
    }
    return variables;
  }

  /** Tells somebody of each new one, until the returned action is run. */
  public Runnable listen(Consumer<UrbiUVar> listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }
}
