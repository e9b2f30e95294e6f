package org.urbi.kernel;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.message.Message;

/**
 * What the client of a connection has asked of the kernel thread, by numbers that the messages
 * carry: in a replay the same messages come, and nobody waits for an answer.
 *
 * @param <T> who waits for the answer
 */
final class Questions<T> {
  private final Inbox inbox;
  private final Consumer<T> dropped;
  private final AtomicInteger asked = new AtomicInteger();
  private final Map<Integer, T> waiting = new ConcurrentHashMap<>();
  private volatile boolean closed;

  /**
   * @param dropped told who waits in vain, because the connection is closed
   */
  Questions(Inbox inbox, Consumer<T> dropped) {
    this.inbox = inbox;
    this.dropped = dropped;
  }

  /**
   * Asks; from any thread.
   *
   * @param message makes the message, with its number
   * @return the number
   */
  int ask(T waits, IntFunction<Message> message) {
    int question = asked.incrementAndGet();
    waiting.put(question, waits);
    inbox.post(message.apply(question));
    if (closed) {
      dropAll();
    }
    return question;
  }

  /** Who waits for the answer, once; null if nobody does. */
  @Nullable T take(int question) {
    return waiting.remove(question);
  }

  /** The connection is closed. */
  void close() {
    closed = true;
    dropAll();
  }

  private void dropAll() {
    waiting.values().forEach(dropped);
    waiting.clear();
  }
}
