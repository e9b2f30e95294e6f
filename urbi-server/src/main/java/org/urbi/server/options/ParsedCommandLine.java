package org.urbi.server.options;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A parsed command line: options in their order, then the other arguments. */
record ParsedCommandLine(List<Occurrence> options, List<String> rest) {
  /**
   * An option on the command line.
   *
   * @param value null if it has none
   */
  record Occurrence(Option option, @Nullable String value) {}

  ParsedCommandLine() {
    this(new ArrayList<>(), new ArrayList<>());
  }
}
