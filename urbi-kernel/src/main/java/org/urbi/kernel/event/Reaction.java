package org.urbi.kernel.event;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Code that waits to be executed each time something happens, as people see it. */
public interface Reaction extends TagScope.Attachment {
  /**
   * What is known of a reaction.
   *
   * @param kind its word of the language: {@code at}, {@code whenever}, {@code every}, {@code
   *     watch} …
   * @param span where it was written; null when nobody knows
   * @param scope the tags under which it was executed
   * @param lobby for which its code runs
   * @param occurrences how often its code was executed, and when last
   * @param event that it waits for, or that it emits; null if there is none
   */
  record Facts(
      String kind,
      @Nullable Span span,
      TagScope scope,
      UrbiObject lobby,
      Occurrences occurrences,
      @Nullable UrbiEvent event) {}

  /** What is known of it; made when somebody looks. */
  Facts facts();

  /**
   * The names of what its condition has read when it was last evaluated; empty if it has none.
   *
   * @param most so many names at most
   */
  default List<String> read(int most) {
    return List.of();
  }
}
