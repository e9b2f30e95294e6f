package org.urbi.kernel.uobject;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.LooseReference;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UClass;
import urbi.UObject;

/**
 * An urbiscript object and the Java object behind it. It keeps the urbiscript object alive only
 * while one of its functions is called periodically. What can lead back to that object (the lobby,
 * of which it may be a slot, the arguments it was made with, the values of its variables) is kept
 * by the object alone.
 */
final class Instance {
  /**
   * How the object was made: for which lobby; with which arguments, once {@code init} has ended.
   * And its variables that Java uses.
   */
  private record Origin(
      UrbiObject lobby, UrbiObject @Nullable [] initArguments, Set<UrbiUVar> variables)
      implements UrbiObject.Companion {}

  private final String name;
  private final LooseReference<UrbiObject> object;
  private final Map<String, BoundFunction> functions = new LinkedHashMap<>();
  private UClass type;
  private @Nullable UObject java;
  private @Nullable UrbiObject keptAlive;
  private boolean published;

  /**
   * @param lobby the lobby for which it was created, and for which its own activities run
   */
  Instance(String name, UClass type, UrbiObject object, UrbiObject lobby, Journal journal) {
    this.name = name;
    this.type = type;
    this.object = new LooseReference<>(journal, object);
    object.setCompanion(new Origin(lobby, null, new HashSet<>(0)));
  }

  String name() {
    return name;
  }

  /** The urbiscript object; null once it was garbage collected. */
  @Nullable UrbiObject object() {
    return object.get();
  }

  /** The lobby it was created for; null once the urbiscript object was garbage collected. */
  @Nullable UrbiObject lobby() {
    Origin origin = origin();
    return origin == null ? null : origin.lobby;
  }

  private @Nullable Origin origin() {
    UrbiObject made = object();
    return made == null ? null : (Origin) made.companion();
  }

  UClass type() {
    return type;
  }

  /** The Java object; null while it is being created. */
  @Nullable UObject java() {
    return java;
  }

  void setJava(UObject behind) {
    java = behind;
  }

  /** Sets another class of the same name, which has replaced the old one. */
  void setType(UClass other) {
    type = other;
  }

  /** Whether it is a slot of {@code uobjects} that does not keep the object alive. */
  boolean isPublished() {
    return published;
  }

  void setPublished() {
    published = true;
  }

  /** The functions that are bound, by their names. */
  Map<String, BoundFunction> functions() {
    return functions;
  }

  /** The arguments of its {@code init}; null if it was not called. */
  UrbiObject @Nullable [] initArguments() {
    Origin origin = origin();
    return origin == null ? null : origin.initArguments;
  }

  void setInitArguments(UrbiObject[] arguments) {
    UrbiObject made = object();
    Origin origin = origin();
    if (made != null && origin != null) {
      made.setCompanion(new Origin(origin.lobby, arguments, origin.variables));
    }
  }

  /** Keeps a variable for as long as the urbiscript object is there. */
  void keep(UrbiUVar variable) {
    Origin origin = origin();
    if (origin != null) {
      origin.variables.add(variable);
    }
  }

  /** Whether urbiscript code listens to its variables or events. */
  boolean isListenedTo() {
    UrbiObject listened = object.peek();
    if (listened == null) {
      return false;
    }
    for (Symbol slot : listened.localSlotNames()) {
      SlotData data = listened.slotData(slot);
      boolean watched =
          data != null
              && (data.dependents() != null && !data.dependents().isEmpty()
                  || data.changed() instanceof UrbiEvent changed && changed.hasSubscribers());
      if (watched
          || listened.localSlot(slot) instanceof UrbiEvent event && event.hasSubscribers()) {
        return true;
      }
    }
    return false;
  }

  /** Sets whether it keeps the urbiscript object alive. */
  void keepAlive(boolean alive) {
    keptAlive = alive ? object.get() : null;
  }
}
