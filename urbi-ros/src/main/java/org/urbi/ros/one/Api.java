package org.urbi.ros.one;

import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Function;
import org.urbi.ros.graph.RosException;

/**
 * The methods of a master or of another node: each is told who calls, and answers with a code, a
 * text and a value.
 *
 * @param caller the name of our node
 */
record Api(XmlRpcClient client, URI uri, String caller) {
  private static final int DONE = 1;

  /**
   * Calls a method. Fails with a {@link RosException} if nobody answers, or with what is not
   * expected, or with a refusal.
   */
  <T> CompletableFuture<T> call(Function<Object, T> reading, String method, Object... arguments) {
    List<Object> all = new ArrayList<>(List.of(caller));
    all.addAll(List.of(arguments));
    CompletableFuture<Object> answer;
    try {
      answer = client.call(uri, method, all);
    } catch (IllegalArgumentException e) {
      answer = CompletableFuture.failedFuture(e);
    }
    return answer.handle((value, failure) -> {
      if (failure != null) {
        Throwable cause =
            failure instanceof CompletionException && failure.getCause() != null
                ? failure.getCause()
                : failure;
        throw new RosException(uri + " does not answer " + method + ": " + describe(cause), cause);
      }
      try {
        List<?> triple = (List<?>) value;
        if ((Integer) triple.get(0) != DONE) {
          throw new RosException(String.valueOf(triple.get(1)));
        }
        return reading.apply(triple.get(2));
      } catch (ClassCastException | IndexOutOfBoundsException e) {
        throw new RosException(uri + " answers " + method + " in no way that ROS knows", e);
      }
    });
  }

  private static String describe(Throwable failure) {
    String message = failure.getMessage();
    return message == null ? failure.getClass().getSimpleName() : message;
  }
}
