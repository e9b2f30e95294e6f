package org.urbi.kernel.outside;

import java.io.IOException;
import org.urbi.kernel.error.Problem;

/** Something that a confined kernel may not do; the message says what. */
public final class ConfinedException extends IOException {
  private static final long serialVersionUID = 1;

  ConfinedException(Problem problem) {
    super(problem.text());
  }
}
