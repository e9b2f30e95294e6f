package org.urbi.kernel.job;

import java.util.List;
import org.urbi.kernel.error.UrbiException;

/** Code of a job that has called other code. */
public interface Place {
  /** The calls that lead to the code, innermost first. */
  List<UrbiException.Call> backtrace();

  /** How many calls those are. */
  int depth();
}
