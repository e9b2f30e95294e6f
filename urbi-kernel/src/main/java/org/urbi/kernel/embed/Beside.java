package org.urbi.kernel.embed;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/**
 * What stays beside the message of a request: it is no data.
 *
 * @param objects those that the message names by their numbers
 * @param listener of the program; in a replay nobody listens
 * @param function that is written in Java
 */
record Beside(
    Map<Integer, UrbiObject> objects,
    Consumer<? super List<Object>> listener,
    @Nullable JavaFunction function) {
  private static final Consumer<List<Object>> NOBODY = payload -> {};

  static Beside of(Map<Integer, UrbiObject> objects) {
    return new Beside(objects, NOBODY, null);
  }

  static Beside of(Consumer<? super List<Object>> listener) {
    return new Beside(Map.of(), listener, null);
  }

  static Beside of(JavaFunction function) {
    return new Beside(Map.of(), NOBODY, function);
  }
}
