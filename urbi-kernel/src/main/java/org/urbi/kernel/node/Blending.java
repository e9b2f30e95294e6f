package org.urbi.kernel.node;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.job.TagStop;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.object.BlendMode;
import org.urbi.kernel.object.SlotBlending;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/**
 * Combines simultaneous assignments to one slot (the property {@code blend}). Assignments of
 * different jobs in one cycle are simultaneous, as are motions ({@code x = 1 time: 2s}) from start
 * to end.
 */
public final class Blending implements SlotBlending {
  private final BlendMode mode;
  private final Map<Job, TagState> motions = new LinkedHashMap<>();
  private final Map<Job, Part> parts = new LinkedHashMap<>();
  private final Set<Job> waiting = new LinkedHashSet<>();

  /** The last assignment of a job. */
  private record Part(double value, long cycle) {}

  public Blending(BlendMode mode) {
    this.mode = mode;
  }

  // ------------------------------------------------------------------ motions

  /** Executes a motion when the blend mode allows it; void if it is dropped. */
  UrbiObject move(Frame frame, Supplier<UrbiObject> motion) {
    Job job = frame.job;
    if (motions.containsKey(job)) {
      return motion.get();
    }
    if (!begin(frame)) {
      return frame.interpreter.values().voidObject;
    }
    var tag = new TagState(frame.interpreter.prototypes.tag.cloned());
    TagScope scope = job.enter(tag);
    motions.put(job, tag);
    waiting.remove(job);
    try {
      return motion.get();
    } catch (TagStop stop) {
      if (stop.scope() != scope) {
        throw stop;
      }
      return stop.value();
    } finally {
      motions.remove(job);
      job.leave(scope);
      next();
    }
  }

  /** Whether the job may assign; waits for its turn if the mode is {@code queue}. */
  private boolean begin(Frame frame) {
    switch (mode) {
      case DISCARD -> {
        return motions.isEmpty();
      }
      case CANCEL -> {
        for (TagState motion : new ArrayList<>(motions.values())) {
          motion.stop(frame.job.scheduler(), frame.interpreter.values().voidObject);
        }
        motions.clear();
      }
      case QUEUE -> waitForTurn(frame.job);
      default -> {}
    }
    return true;
  }

  private void waitForTurn(Job job) {
    waiting.add(job);
    boolean came = false;
    try {
      while (!motions.isEmpty() || waiting.iterator().next() != job) {
        job.waitForWake(Wait.SIGNAL);
      }
      came = true;
    } finally {
      if (!came) {
        waiting.remove(job);
        next();
      }
    }
  }

  private void next() {
    if (motions.isEmpty() && !waiting.isEmpty()) {
      waiting.iterator().next().wake();
    }
  }

  // ------------------------------------------------------------------ values

  /** The new value of the slot when a job assigns this one; null if the slot is not changed. */
  @Nullable UrbiObject assigned(Frame frame, UrbiObject value) {
    Job job = frame.job;
    if (mode == BlendMode.MIX || mode == BlendMode.ADD) {
      return value instanceof UrbiFloat number ? blended(frame, job, number.value()) : value;
    }
    if (!motions.containsKey(job)) {
      if (!begin(frame)) {
        return null;
      }
      waiting.remove(job);
      next();
    }
    return value;
  }

  private UrbiObject blended(Frame frame, Job job, double value) {
    long cycle = job.scheduler().time().cycle();
    parts
        .entrySet()
        .removeIf(part -> part.getValue().cycle != cycle && !motions.containsKey(part.getKey()));
    parts.put(job, new Part(value, cycle));
    double sum = 0;
    for (Part part : parts.values()) {
      sum += part.value;
    }
    return frame.interpreter.values().number(mode == BlendMode.MIX ? sum / parts.size() : sum);
  }
}
