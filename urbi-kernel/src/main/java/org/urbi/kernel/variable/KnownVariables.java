package org.urbi.kernel.variable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.LooseObjects;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;

/** All variables of a kernel, as far as they are still used. On the kernel thread. */
public final class KnownVariables implements UrbiObject.Companion {
  private final LooseObjects<UrbiUVar> all;
  private final List<Consumer<UrbiUVar>> listeners = new ArrayList<>(0);

  KnownVariables(Journal journal) {
    all = new LooseObjects<>(journal);
  }

  /** The variables of that kernel; the prototype of all variables keeps the list. */
  public static KnownVariables of(Interpreter interpreter) {
    UrbiObject prototype = interpreter.world().prototype("UVar");
    if (prototype.companion() instanceof KnownVariables known) {
      return known;
    }
    KnownVariables made = new KnownVariables(interpreter.scheduler().journal());
    prototype.setCompanion(made);
    return made;
  }

  void add(UrbiUVar variable) {
    all.add(variable);
    List.copyOf(listeners).forEach(listener -> listener.accept(variable));
  }

  /** All of them, in the order in which they were made. */
  public List<UrbiUVar> all() {
    return all.all();
  }

  /** Tells somebody of each new one, until the returned action is run. */
  public Runnable listen(Consumer<UrbiUVar> listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }
}
