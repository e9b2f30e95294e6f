package org.urbi.kernel.uobject;

import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.variable.Datum;
import org.urbi.kernel.variable.UrbiUVar;

/**
 * The values that functions of UObjects are being told of and which are nowhere else: those that go
 * through an input port, and those that are not copied.
 */
final class Tells {
  private record Tell(Job job, UrbiUVar variable, Datum value) {}

  private final List<Tell> tells = new ArrayList<>();

  void begin(Job job, UrbiUVar variable, Datum value) {
    if (variable.isInput() || value.foreign() != null) {
      tells.add(new Tell(job, variable, value));
    }
  }

  void end(Job job, UrbiUVar variable, Datum value) {
    for (int i = tells.size() - 1; i >= 0; i--) {
      Tell tell = tells.get(i);
      if (tell.job == job && tell.variable == variable && tell.value == value) {
        tells.remove(i);
        return;
      }
    }
  }

  /** What that job is telling of a variable, or null. */
  Datum find(Job job, UrbiUVar variable) {
    for (int i = tells.size() - 1; i >= 0; i--) {
      Tell tell = tells.get(i);
      if (tell.job == job && tell.variable == variable) {
        return tell.value;
      }
    }
    return null;
  }
}
