package org.urbi.kernel.uobject;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.variable.Datum;
import org.urbi.kernel.variable.UrbiUVar;

/**
 * The values of notifications in progress that no variable stores: values that pass through an
 * input port, and values that are not copied. Functions of UObjects that are called for a change
 * can read them from here.
 */
final class PendingNotifications {
  private record Delivery(Job job, UrbiUVar variable, Datum value) {}

  private final List<Delivery> underWay = new ArrayList<>();

  void begin(Job job, UrbiUVar variable, Datum value) {
    if (variable.isInput() || value.foreign() != null) {
      underWay.add(new Delivery(job, variable, value));
    }
  }

  void end(Job job, UrbiUVar variable, Datum value) {
    for (int i = underWay.size() - 1; i >= 0; i--) {
      Delivery delivery = underWay.get(i);
      if (delivery.job == job && delivery.variable == variable && delivery.value == value) {
        underWay.remove(i);
        return;
      }
    }
  }

  /** The value of a variable for which that job is calling a function, or null. */
  @Nullable Datum find(Job job, UrbiUVar variable) {
    for (int i = underWay.size() - 1; i >= 0; i--) {
      Delivery delivery = underWay.get(i);
      if (delivery.job == job && delivery.variable == variable) {
        return delivery.value;
      }
    }
    return null;
  }
}
