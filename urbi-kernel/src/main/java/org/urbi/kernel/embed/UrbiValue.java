package org.urbi.kernel.embed;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Data;
import org.urbi.kernel.message.Message;
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
  private final int number;
  private final UrbiObject object;

  /** Only {@link Embedding#handle} makes some, which gives them their numbers. */
  UrbiValue(Embedding embedding, int number, UrbiObject object) {
    this.embedding = embedding;
    this.number = number;
    this.object = object;
  }

  UrbiObject object(Embedding wanted) {
    if (embedding != wanted) {
      throw new IllegalArgumentException("an object of another kernel");
    }
    return object;
  }

  int number() {
    return number;
  }

  /** The value of a slot, its own or an inherited one; a function is not called. */
  public @Nullable Object get(String slot) {
    return ask(id -> new Message.SlotRead(id, number, Utf8Text.toUrbi(slot)));
  }

  /** Assigns a slot of the object itself, which is created if need be. */
  public void set(String slot, Object value) {
    GivenValues given = given();
    Data read = given.value(value);
    embedding.ask(id -> new Message.SlotWritten(id, number, Utf8Text.toUrbi(slot), read), given);
  }

  /** Whether the object itself has that slot. */
  public boolean has(String slot) {
    return known(id -> new Message.SlotSought(id, number, Utf8Text.toUrbi(slot)));
  }

  /** Removes a slot of the object itself; does nothing when it has none of that name. */
  public void remove(String slot) {
    ask(id -> new Message.SlotRemoved(id, number, Utf8Text.toUrbi(slot)));
  }

  /** The names of the slots of the object itself, in the order of their creation. */
  public List<String> slotNames() {
    return known(id -> new Message.SlotsListed(id, number));
  }

  /** Calls a method and waits for its result. */
  public @Nullable Object call(String method, Object... arguments) {
    GivenValues given = given();
    Data read = given.list(arguments);
    return embedding.ask(
        id -> new Message.MethodCalled(id, number, Utf8Text.toUrbi(method), read), given);
  }

  /** Calls the object itself, which is a function; its target is the lobby. */
  public @Nullable Object apply(Object... arguments) {
    GivenValues given = given();
    Data read = given.list(arguments);
    return embedding.ask(id -> new Message.ObjectCalled(id, number, read), given);
  }

  private GivenValues given() {
    GivenValues given = new GivenValues(embedding);
    given.number(this);
    return given;
  }

  private <T> @Nullable T ask(IntFunction<Message.OfProgram> what) {
    return embedding.ask(what, given());
  }

  /** Asks for what is never nil. */
  private <T> T known(IntFunction<Message.OfProgram> what) {
    return requireNonNull(this.<T>ask(what), "what is asked for is there");
  }

  /** As {@code asString} of urbiscript; never throws. */
  @Override
  public String toString() {
    try {
      return known(id -> new Message.ObjectShown(id, number));
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
