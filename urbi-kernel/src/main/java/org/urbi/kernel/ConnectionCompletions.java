package org.urbi.kernel;

import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.lobby.Completion;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.message.Message;

/** What a client asks of names that it has begun to type. */
final class ConnectionCompletions {
  /** How many questions may wait: people ask one after the other. */
  private static final int MOST_WAITING = 16;

  private final Kernel kernel;
  private final int number;
  private final AtomicInteger questions = new AtomicInteger();
  private final Map<Integer, CompletableFuture<List<String>>> waiting = new ConcurrentHashMap<>();

  /**
   * @param number of the receiver of the connection's messages
   */
  ConnectionCompletions(Kernel kernel, int number) {
    this.kernel = kernel;
    this.number = number;
  }

  /**
   * Asks, from any thread; of a connection that is gone there are no names, nor for who asks faster
   * than the kernel answers.
   */
  CompletableFuture<List<String>> ask(String text, boolean gone) {
    CompletableFuture<List<String>> names = new CompletableFuture<>();
    if (gone || waiting.size() >= MOST_WAITING) {
      names.complete(List.of());
    } else {
      int question = questions.incrementAndGet();
      waiting.put(question, names);
      kernel.inbox().post(new Message.CompletionRequested(number, question, text));
    }
    return names;
  }

  // ------------------------------------------------------------------ on the kernel thread

  /** Answers; without a lobby there are no names. */
  void take(Message.CompletionRequested asked, @Nullable UrbiLobby lobby) {
    CompletableFuture<List<String>> names = waiting.remove(asked.question());
    if (names != null) {
      names.complete(lobby == null ? List.of() : Completion.of(lobby, asked.text()));
    }
  }

  /** Nobody answers any more. */
  void close() {
    waiting.values().forEach(names -> names.complete(List.of()));
  }
}
