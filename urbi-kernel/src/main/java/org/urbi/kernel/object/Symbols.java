package org.urbi.kernel.object;

import java.lang.ref.ReferenceQueue;
import java.lang.ref.WeakReference;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;

/**
 * The names of one kernel, each once. A name that no object and no code has any more is forgotten:
 * what clients call their variables comes and goes with them.
 */
final class Symbols {
  private static final class Known extends WeakReference<Symbol> {
    final String name;

    Known(Symbol symbol, ReferenceQueue<Symbol> forgotten) {
      super(symbol, forgotten);
      name = symbol.name();
    }
  }

  private final Map<String, Known> byName = new HashMap<>();
  private final ReferenceQueue<Symbol> forgotten = new ReferenceQueue<>();

  /** The one symbol of that name. */
  Symbol get(String name) {
    Known known = byName.get(name);
    Symbol symbol = known == null ? null : known.get();
    if (symbol == null) {
      sweep();
      symbol = new Symbol(name);
      byName.put(name, new Known(symbol, forgotten));
    }
    return symbol;
  }

  private void sweep() {
    for (Object gone = forgotten.poll(); gone != null; gone = forgotten.poll()) {
      Known known = (Known) gone;
      byName.remove(known.name, known);
    }
  }

  void forEach(Consumer<Symbol> action) {
    for (Known known : byName.values()) {
      Symbol symbol = known.get();
      if (symbol != null) {
        action.accept(symbol);
      }
    }
  }
}
