package urbi.remote;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import urbi.UClientException;
import urbi.UValue;

/** The requests to the kernel whose answers the remote process waits for. */
final class PendingRequests {
  private final AtomicInteger last = new AtomicInteger();
  private final Map<Integer, PendingRequest> waiting = new ConcurrentHashMap<>();
  private volatile @Nullable String lost;

  private record PendingRequest(Consumer<UValue> first, CompletableFuture<UValue> answer) {}

  /** Sends a request. */
  interface Question {
    void send(int number);
  }

  /**
   * Asks and waits.
   *
   * @param first is given the answer before anything is read that has come after it
   * @throws IllegalArgumentException with the kernel's words, if it refuses
   * @throws UClientException if the connection is lost before the answer
   */
  UValue ask(Question question, Consumer<UValue> first) {
    int number = last.incrementAndGet();
    var answer = new CompletableFuture<UValue>();
    waiting.put(number, new PendingRequest(first, answer));
    try {
      if (lost != null) {
        throw new UClientException(lost);
      }
      question.send(number);
      return answer.get();
    } catch (ExecutionException e) {
      throw (RuntimeException) e.getCause();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new UClientException("interrupted while waiting for the kernel", e);
    } finally {
      waiting.remove(number);
    }
  }

  void answer(int number, UValue value) {
    PendingRequest asked = waiting.get(number);
    if (asked != null) {
      asked.first.accept(value);
      asked.answer.complete(value);
    }
  }

  void refuse(int number, String reason) {
    PendingRequest asked = waiting.get(number);
    if (asked != null) {
      asked.answer.completeExceptionally(new IllegalArgumentException(reason));
    }
  }

  /** The connection is lost: all pending requests fail. */
  void lost(String reason) {
    lost = reason;
    waiting
        .values()
        .forEach(asked -> asked.answer.completeExceptionally(new UClientException(reason)));
  }
}
