package org.urbi.kernel.library.concurrent;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A queue of published values (manual, "PubSub.Subscriber"). */
final class UrbiSubscriber extends UrbiObject {
  private final ArrayDeque<UrbiObject> values = new ArrayDeque<>();
  private final Set<Job> waiting = new LinkedHashSet<>();

  UrbiSubscriber(Shape shape) {
    super(shape);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiSubscriber(cloneShape());
  }

  void enqueue(UrbiObject value) {
    values.add(value);
    for (Job job : List.copyOf(waiting)) {
      job.wake();
    }
  }

  /** Waits until there is a value. */
  void awaitValue(Job job) {
    waiting.add(job);
    try {
      while (values.isEmpty()) {
        job.waitForWake(Wait.SIGNAL);
      }
    } finally {
      waiting.remove(job);
    }
  }

  UrbiObject poll() {
    return values.poll();
  }

  List<UrbiObject> pollAll() {
    List<UrbiObject> all = new ArrayList<>(values);
    values.clear();
    return all;
  }
}
