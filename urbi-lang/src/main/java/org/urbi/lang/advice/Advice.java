package org.urbi.lang.advice;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What people are told about a mistake beyond its message.
 *
 * @param hint what to do about it; null when nobody knows
 * @param notes other places that have to do with it
 */
public record Advice(@Nullable String hint, List<Note> notes) {
  /** Only a hint, if any. */
  public static Advice of(@Nullable String hint) {
    return new Advice(hint, List.of());
  }
}
