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
import org.urbi.kernel.object.BlendMode;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/**
 * What becomes of several assignments of one slot at a time (properties of variables, {@code
 * blend}). Those of different jobs in one cycle are at the same time, and so are motions ({@code x
 * = 1 time: 2s}) from their beginning to their end.
 */
public final class Blending {
  private final BlendMode mode;
  private final Map<Job, TagState> motions = new LinkedHashMap<>();
  private final Map<Job, Part> parts = new LinkedHashMap<>();
  private final Set<Job> waiting = new LinkedHashSet<>();

  /** What a job has assigned last. */
  private record Part(double value, long cycle) {}

  public Blending(BlendMode mode) {
    this.mode = mode;
  }

  // ------------------------------------------------------------------ motions

  /** Executes a motion, at its time; void when there is none. */
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

  /** Whether the job may assign now; waits for that where it has to. */
  private boolean begin(Frame frame) {
    switch (mode) {
      case DISCARD -> {
        return motions.isEmpty();
      }
      case CANCEL -> {
        for (TagState motion : new ArrayList<>(motions.values())) {
          motion.stop(frame.interpreter.values().voidObject);
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
        job.waitForWake();
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

  /** The value that the slot gets when a job assigns this one; null when it keeps its own. */
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
    long cycle = job.scheduler().cycle();
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
