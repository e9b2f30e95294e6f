package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.event.WatchedSources;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.log.LogLines;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.variable.KnownVariables;
import org.urbi.kernel.variable.UrbiUVar;

/**
 * Tells somebody of all variables with hooks (manual, "UVar"), of the slots that he names besides,
 * and of the values of those that he follows. What nobody follows costs nothing. On the kernel
 * thread.
 */
public final class VariableFeed {
  /** How many variables somebody is told of. */
  private static final int MOST = 10_000;

  /** For how long names are not searched again, for each that was found, in nanoseconds. */
  private static final long PAUSE = 20_000;

  private final Interpreter interpreter;
  private final Scheduler scheduler;
  private final Supplier<? extends List<? extends UrbiObject>> roots;
  private final VariableListener listener;
  private final boolean all;
  private final WorldTime time;
  private final List<FollowedVariable> variables = new ArrayList<>();
  private final List<FollowedPath> paths = new ArrayList<>();
  private final Map<Integer, FollowedSlot> told = new HashMap<>();
  private final List<UrbiUVar> arrived = new ArrayList<>();
  private final WatchedSources structure = new WatchedSources(this::searchLater);
  private final Runnable notArriving;
  private final Runnable notLogging;
  private Timers.@Nullable Timer search;
  private long searchFrom;
  private boolean refuses;
  private boolean ended;
  private int last;

  /**
   * Begins to tell.
   *
   * @param log whose lines are told, too
   * @param roots where names of slots are looked up, in this order
   * @param all whether everything is followed at once
   * @param wanted the paths of slots that are told besides
   */
  public VariableFeed(
      Interpreter interpreter,
      LogLines log,
      Supplier<? extends List<? extends UrbiObject>> roots,
      VariableListener listener,
      boolean all,
      List<String> wanted) {
    this.interpreter = interpreter;
    this.scheduler = interpreter.scheduler();
    this.roots = roots;
    this.listener = listener;
    this.all = all;
    this.time = new WorldTime(scheduler);
    KnownVariables known = KnownVariables.of(interpreter);
    notArriving = known.listen(this::arrive);
    notLogging = log.listen(line -> listener.logged(time.now(), line));
    arrived.addAll(known.all());
    wanted.forEach(this::want);
    scheduler.atEndOfTick(this::takeArrived);
  }

  private void want(String path) {
    if (SlotPath.isPath(path) && paths.size() < MOST) {
      FollowedPath slot = new FollowedPath(this, path(path), interpreter.world());
      paths.add(slot);
      slot.begin();
    } else {
      listener.refused(Problem.NO_PATH.text(path));
    }
  }

  private SlotPath path(String text) {
    return new SlotPath(interpreter, roots, text);
  }

  // ------------------------------------------------------------------ which there are

  private void arrive(UrbiUVar variable) {
    arrived.add(variable);
    if (arrived.size() == 1) {
      scheduler.atEndOfTick(this::takeArrived);
    }
  }

  private void takeArrived() {
    if (ended) {
      return;
    }
    if (scheduler.now() >= searchFrom) {
      searchNames();
    } else {
      take(new VariableNames(List.of()));
      searchLater();
    }
  }

  private void take(VariableNames names) {
    for (UrbiUVar variable : arrived) {
      if (variables.size() == MOST) {
        refuseOthers();
        break;
      }
      FollowedVariable one = new FollowedVariable(this, interpreter, variable, names.of(variable));
      variables.add(one);
      one.begin();
    }
    arrived.clear();
  }

  private void refuseOthers() {
    if (!refuses) {
      refuses = true;
      listener.refused(Problem.TOO_MANY_VARIABLES.text(MOST));
    }
  }

  /** A name may have come or gone. */
  private void searchLater() {
    if (search == null && !ended) {
      search = scheduler.timers().add(Math.max(scheduler.now(), searchFrom), this::searchNames);
    }
  }

  private void searchNames() {
    if (search != null) {
      search.cancel();
      search = null;
    }
    List<? extends UrbiObject> from = roots.get();
    VariableNames names = new VariableNames(from);
    searchFrom = scheduler.now() + PAUSE * names.size();
    variables.removeIf(each -> {
      boolean gone = !each.isThere();
      if (gone) {
        each.end();
      }
      return gone;
    });
    for (FollowedVariable each : variables) {
      UrbiUVar variable = each.variable();
      if (variable != null && names.knows(variable)) {
        each.rename(names.of(variable));
      }
    }
    take(names);
    watch(from);
  }

  /** There is another root. */
  public void rootsChanged() {
    paths.forEach(FollowedPath::invalidated);
    searchLater();
  }

  /** A variable whose object gets a name is told under that name. */
  private void watch(List<? extends UrbiObject> from) {
    World world = interpreter.world();
    Dependencies.Tracker outer = world.tracker;
    world.tracker = structure;
    structure.begin();
    from.forEach(UrbiObject::noteStructureRead);
    structure.end();
    world.tracker = outer;
  }

  // ------------------------------------------------------------------ what is followed

  /** Begins or ends to follow a variable; one that has gone meanwhile is passed over. */
  public void follow(int variable, boolean on) {
    FollowedSlot slot = told.get(variable);
    if (slot != null) {
      slot.follow(on);
    }
  }

  boolean followsAll() {
    return all;
  }

  int appeared(FollowedSlot slot, VariableKind kind) {
    told.put(++last, slot);
    listener.appeared(last, slot.path(), kind);
    return last;
  }

  void disappeared(FollowedSlot slot) {
    told.remove(slot.number());
    listener.gone(slot.number());
  }

  void tell(int variable, @Nullable Object value) {
    listener.value(variable, time.now(), value);
  }

  /**
   * The slot of a path: of a variable that was told under it, or else as code would find it; null
   * if it is not there.
   */
  public @Nullable GivenSlot find(String path) {
    for (FollowedVariable each : variables) {
      UrbiUVar variable = each.path().equals(path) ? each.variable() : null;
      UrbiObject owner = variable == null ? null : variable.owner();
      if (variable != null && owner != null) {
        return new GivenSlot(owner, FollowedVariable.slot(variable), variable.visible().value());
      }
    }
    return find(interpreter, roots, path);
  }

  /** The slot of a path as code would find it; null if it is not there. */
  public static @Nullable GivenSlot find(
      Interpreter interpreter, Supplier<? extends List<? extends UrbiObject>> roots, String path) {
    return SlotPath.isPath(path) ? GivenSlot.of(new SlotPath(interpreter, roots, path)) : null;
  }

  /** Tells nothing any more. */
  public void end() {
    ended = true;
    notArriving.run();
    notLogging.run();
    structure.close();
    if (search != null) {
      search.cancel();
    }
    variables.forEach(each -> each.listen(false));
    paths.forEach(FollowedPath::close);
  }
}
