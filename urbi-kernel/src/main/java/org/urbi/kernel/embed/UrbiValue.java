package org.urbi.kernel.embed;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;

/**
 * A handle on an urbiscript object that has no Java counterpart: an object with slots, a function,
 * an event… Its methods may be called from any thread and wait for the kernel; within a function
 * that was given to {@link Embedding#define} they are executed at once. Two handles are equal when
 * the object is the same one.
 *
 * <p>All methods but {@link #toString}, {@code equals} and {@code hashCode} throw {@link UrbiError}
 * for errors in urbiscript, and {@link IllegalStateException} when the kernel has ended.
 */
public final class UrbiValue {
  private final Embedding embedding;
  private final UrbiObject object;

  UrbiValue(Embedding embedding, UrbiObject object) {
    this.embedding = embedding;
    this.object = object;
  }

  UrbiObject object(Embedding wanted) {
    if (embedding != wanted) {
      throw new IllegalArgumentException("an object of another kernel");
    }
    return object;
  }

  /** The value of a slot, its own or an inherited one; a function is not called. */
  public @Nullable Object get(String slot) {
    return embedding.ask(frame ->
        JavaValues.toJava(embedding, frame.interpreter().get(frame, object, symbol(slot))));
  }

  /** Assigns a slot of the object itself, which is created if need be. */
  public void set(String slot, Object value) {
    JavaValues.Maker maker = JavaValues.fromJava(embedding, value);
    embedding.ask(frame -> {
      Symbol name = symbol(slot);
      UrbiObject made = maker.make(frame);
      if (object.hasLocalSlot(name)) {
        SlotUpdate.assign(frame, object, name, made);
      } else {
        SlotUpdate.create(frame, object, name, made);
      }
      return null;
    });
  }

  /** Whether the object itself has that slot. */
  public boolean has(String slot) {
    return known(frame -> object.hasLocalSlot(symbol(slot)));
  }

  /** Removes a slot of the object itself; does nothing when it has none of that name. */
  public void remove(String slot) {
    embedding.ask(frame -> object.removeSlot(symbol(slot)));
  }

  /** The names of the slots of the object itself, in the order of their creation. */
  public List<String> slotNames() {
    return known(frame -> {
      List<String> names = new ArrayList<>();
      for (Symbol name : object.localSlotNames()) {
        names.add(Utf8Text.toJava(name.name()));
      }
      return names;
    });
  }

  /** Calls a method and waits for its result. */
  public @Nullable Object call(String method, Object... arguments) {
    Embedding.Arguments made = embedding.arguments(arguments);
    return embedding.ask(frame ->
        JavaValues.toJava(
            embedding,
            frame.interpreter().send(frame, object, Utf8Text.toUrbi(method), made.make(frame))));
  }

  /** Calls the object itself, which is a function; its target is the lobby. */
  public @Nullable Object apply(Object... arguments) {
    Embedding.Arguments made = embedding.arguments(arguments);
    return embedding.ask(frame ->
        JavaValues.toJava(
            embedding,
            frame.interpreter().call(frame, object, frame.job().lobby(), made.make(frame))));
  }

  /** Runs a task whose result is never nil. */
  private <T> T known(Embedding.Task<T> task) {
    return requireNonNull(embedding.ask(task), "what is asked for is there");
  }

  private Symbol symbol(String name) {
    return object.world().symbol(Utf8Text.toUrbi(name));
  }

  /** As {@code asString} of urbiscript; never throws. */
  @Override
  public String toString() {
    try {
      return known(frame -> Utf8Text.toJava(frame.interpreter().asString(frame, object)));
    } catch (RuntimeException e) {
      return "UrbiValue (" + e.getMessage() + ")";
    }
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof UrbiValue value && value.object == object;
  }

  @Override
  public int hashCode() {
    return System.identityHashCode(object);
  }
}
