package urbi;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/** The callbacks of a client. */
final class Callbacks {
  private record Callback(
      int id, String tag, Predicate<UMessage> filter, UMessageHandler handler) {}

  private final AtomicInteger last = new AtomicInteger();
  private final List<Callback> callbacks = new CopyOnWriteArrayList<>();

  int add(String tag, Predicate<UMessage> filter, UMessageHandler handler) {
    int id = last.incrementAndGet();
    callbacks.add(new Callback(id, tag, filter, handler));
    return id;
  }

  boolean remove(long id) {
    return callbacks.removeIf(callback -> callback.id == id);
  }

  /** The tag of a callback; null if there is no such callback. */
  @Nullable String tag(long id) {
    return callbacks.stream()
        .filter(callback -> callback.id == id)
        .map(Callback::tag)
        .findFirst()
        .orElse(null);
  }

  /** Calls those that want the message, each whatever the others do. */
  void call(UMessage message) {
    for (Callback callback : callbacks) {
      if (callback.filter.test(message)) {
        UCallbackAction action = UCallbackAction.URBI_CONTINUE;
        try {
          action = callback.handler.onMessage(message);
        } catch (RuntimeException | Error e) {
          Thread thread = Thread.currentThread();
          thread.getUncaughtExceptionHandler().uncaughtException(thread, e);
        }
        if (action == UCallbackAction.URBI_REMOVE) {
          callbacks.remove(callback);
        }
      }
    }
  }
}
