package org.urbi.kernel.node;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.UrbiObject;

/**
 * The calls that a compiled function makes of itself: one that others have called, at level 0, and
 * those inside of it. They have no frames until something needs one, such as an error; then those
 * that are missing are made, the outermost one first. A call has one frame at most.
 */
public final class OwnCalls {
  private static final int[] NO_SITES = {};
  private static final Frame[] NO_FRAMES = {};
  private static final int FIRST_ROOM = 16;

  final Job job;

  /** The function that calls itself, and its target. */
  final Function function;

  final UrbiObject self;

  /** How many calls there are around the one at level 0, and that one. */
  final int depth;

  /** Where the function calls itself, by number. */
  private final List<? extends CallSite> places;

  /** Who has called, and where; null if the interpreter has, and has made the frame. */
  private final @Nullable Frame caller;

  private final @Nullable CallSite from;

  /** For each level the number of the place at which it calls the next one. */
  private int[] sites = NO_SITES;

  private Frame[] frames = NO_FRAMES;

  /** The innermost level that has a frame; -1 if none has one. */
  private int made = -1;

  /** The object with which a call has just answered; or else null. */
  @Nullable UrbiObject answer;

  /**
   * Compiled code has called.
   *
   * @param places where the function calls itself
   */
  OwnCalls(
      Frame caller,
      Function function,
      CallSite from,
      UrbiObject self,
      List<? extends CallSite> places) {
    this.job = caller.job;
    this.function = function;
    this.self = self;
    this.depth = caller.depth + 1;
    this.places = places;
    this.caller = caller;
    this.from = from;
  }

  /** The interpreter has called, and does what belongs to the end of that call. */
  OwnCalls(Frame frame, List<? extends CallSite> places) {
    this.job = frame.job;
    this.function = requireNonNull(frame.function, "only functions are called");
    this.self = frame.self;
    this.depth = frame.depth;
    this.places = places;
    this.caller = null;
    this.from = null;
    this.frames = new Frame[] {frame};
    this.made = 0;
  }

  /** A call of the next level begins. */
  void call(int level, int site) {
    int[] known = sites;
    if (level >= known.length) {
      known = grow(level);
    }
    known[level] = site;
  }

  private int[] grow(int level) {
    sites = Arrays.copyOf(sites, Math.max(FIRST_ROOM, 2 * level));
    return sites;
  }

  /** Where the function calls itself. */
  CallSite place(int site) {
    return places.get(site);
  }

  /** Whether the call has a frame. */
  boolean hasFrame(int level) {
    return level <= made;
  }

  /** Whether the interpreter has called, and so has the frame and does what belongs to its end. */
  boolean isOfInterpreter(int level) {
    return level == 0 && caller == null;
  }

  /** The frame of a call, which is made if nobody has needed it until now. */
  Frame frame(int level) {
    if (level > made) {
      makeFrames(level);
    }
    return frames[level];
  }

  private void makeFrames(int level) {
    if (level >= frames.length) {
      frames = Arrays.copyOf(frames, Math.max(FIRST_ROOM, 2 * level));
    }
    while (made < level) {
      frames[made + 1] = newFrame(made + 1);
      made++;
    }
  }

  private Frame newFrame(int level) {
    return level == 0
        ? newFrame(requireNonNull(caller), requireNonNull(from))
        : newFrame(frames[level - 1], place(sites[level - 1]));
  }

  private Frame newFrame(Frame by, CallSite at) {
    return by.call(at, self, function, Frame.NO_ARGUMENTS);
  }

  /** A call is over, and so are those inside of it. */
  void forget(int level) {
    while (made >= level) {
      frames[made] = null;
      made--;
    }
  }
}
