package org.urbi.kernel.object;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.NoSuchElementException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.time.RandomNumbers;

/**
 * The state that all objects of one kernel share: names, prototypes of types, and the state of
 * lookup caches. Two kernels in one process share nothing.
 */
public final class World {
  private final Symbols symbols = new Symbols();
  private final RandomNumbers randomNumbers = new RandomNumbers();
  private final Map<String, Long> counters = new LinkedHashMap<>();
  private final Shape orphanShape = Shape.root(this, Shape.NO_PROTOS);
  private final Values values = new Values(this);
  private final Map<String, UrbiObject> prototypes = new LinkedHashMap<>();

  /** Whether any lookup has been remembered since all were forgotten. */
  private boolean remembers;

  private long lastUid = 0x7f00_0000L;
  private long lastEvent;
  private Runnable checkpoint = () -> {};

  /** Collects the slots that the condition being evaluated reads; usually null. */
  public Dependencies.@Nullable Tracker tracker;

  /** Counts the changes of prototypes of objects from which others inherit. */
  int protosEpoch;

  /** Whether calls are counted, so that operators must be called as they are written. */
  public boolean profiled;

  /**
   * Sets an action that is called regularly in long loops over objects, and may end them by an
   * exception.
   */
  public void setCheckpoint(Runnable question) {
    checkpoint = question;
  }

  /** Calls that action; from a long loop. */
  void passCheckpoint() {
    checkpoint.run();
  }

  /** The one symbol of that name. */
  public Symbol symbol(String name) {
    return symbols.get(name);
  }

  /** The constants and the factory methods of values. */
  public Values values() {
    return values;
  }

  /** Declares the prototype of a type of the library, such as "Date" or "Exception.Arity". */
  public void declarePrototype(String type, UrbiObject prototype) {
    prototypes.put(type, prototype);
  }

  /** The prototype of a type of the library; null if there is no such type. */
  public @Nullable UrbiObject findPrototype(String type) {
    return prototypes.get(type);
  }

  /**
   * The prototype of a type that the library has declared, even if a program has rebound its name.
   */
  public UrbiObject prototype(String type) {
    UrbiObject known = prototypes.get(type);
    if (known == null) {
      throw new NoSuchElementException("no type of the library: " + type);
    }
    return known;
  }

  /** The random numbers of this kernel. */
  public RandomNumbers randomNumbers() {
    return randomNumbers;
  }

  /** The next number of the counter of that name; the first call sets its first number. */
  public long count(String counter, long first) {
    long number = counters.getOrDefault(counter, first);
    counters.put(counter, number + 1);
    return number;
  }

  /** The shape of objects without prototypes. */
  public Shape orphanShape() {
    return orphanShape;
  }

  /** Invalidates all cached lookups, because the prototypes of an object have changed. */
  void invalidateLookups() {
    protosEpoch++;
    if (remembers) {
      remembers = false;
      symbols.forEach(symbol -> symbol.epoch++);
    }
  }

  /** The epoch of a name, for a lookup that is cached from now on. */
  public int remember(Symbol name) {
    remembers = true;
    return name.epoch();
  }

  /** The number of the next event that is made, for people who look at it. */
  public long nextEvent() {
    return ++lastEvent;
  }

  /** The next unique identifier: they are given in order, so that runs can be repeated exactly. */
  long nextUid() {
    return lastUid += 0x10;
  }
}
