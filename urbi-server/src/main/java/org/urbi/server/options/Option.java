package org.urbi.server.options;

import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * An option of a program.
 *
 * @param names with their dashes, at least one
 * @param label what stands for its value in the help, or null if it has none
 * @param implied the value of an option that was given without one, or null if it needs one
 * @param taker takes each value in the order of the command line
 */
record Option(
    List<String> names,
    @Nullable String label,
    @Nullable String implied,
    String description,
    Consumer<String> taker) {
  boolean hasValue() {
    return label != null;
  }
}
