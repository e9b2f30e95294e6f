package org.urbi.kernel.embed;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/**
 * What belongs to a request but cannot be in its message, because it is no data.
 *
 * @param objects which the message names by their numbers
 * @param listener of the program; in a replay nobody listens
 * @param function that is written in Java
 */
record RequestAttachments(
    Map<Integer, UrbiObject> objects,
    Consumer<? super List<Object>> listener,
    @Nullable JavaFunction function) {
  private static final Consumer<List<Object>> NOBODY = payload -> {};

  static RequestAttachments of(Map<Integer, UrbiObject> objects) {
    return new RequestAttachments(objects, NOBODY, null);
  }

  static RequestAttachments of(Consumer<? super List<Object>> listener) {
    return new RequestAttachments(Map.of(), listener, null);
  }

  static RequestAttachments of(JavaFunction function) {
    return new RequestAttachments(Map.of(), NOBODY, function);
  }
}
