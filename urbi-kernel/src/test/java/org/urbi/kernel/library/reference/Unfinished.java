package org.urbi.kernel.library.reference;

import java.util.Set;

/** The types whose slots do not have all a sentence and an example yet. This list only shrinks. */
final class Unfinished {
  static final Set<String> TYPES = Set.of();

  private Unfinished() {}
}
