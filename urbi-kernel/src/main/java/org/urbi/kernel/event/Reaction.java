package org.urbi.kernel.event;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Code that waits to be executed each time something happens, as people see it. */
public interface Reaction extends TagScope.Attachment {
  /** The word of the language: {@code at}, {@code whenever}, {@code every}, {@code watch} … */
  String kind();

  /** Where it was written; null when nobody knows. */
  @Nullable Span span();

  /** The tags under which it was executed. */
  TagScope scope();

  /** The lobby for which its code runs. */
  UrbiObject lobby();

  /** How often its code was executed, and when last. */
  Occurrences occurrences();

  /** The event that it waits for, or that it emits; null if there is none. */
  @Nullable UrbiEvent event();

  /**
   * The names of what its condition has read when it was last evaluated; empty if it has none.
   *
   * @param most so many names at most
   */
  List<String> read(int most);
}
