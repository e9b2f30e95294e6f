package org.urbi.kernel.object;

import java.lang.ref.ReferenceQueue;
import java.lang.ref.WeakReference;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;

/**
 * The symbols of one kernel, one for each name. A name that no object and no code uses any more is
 * forgotten, so that the variable names of clients that have left take no memory.
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

  /** The unique symbol of that name. */
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
