package org.urbi.kernel.library.system;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.CycleStatistics;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.library.code.Locations;
import org.urbi.kernel.library.code.UrbiProfile;
import org.urbi.kernel.library.concurrent.JobType;
import org.urbi.kernel.library.concurrent.TagType;
import org.urbi.kernel.library.lobby.LobbyType;
import org.urbi.kernel.lobby.Lobbies;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.CodeCompiler;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Profiler;
import org.urbi.kernel.node.RedefinitionMode;
import org.urbi.kernel.node.ScopeEnd;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Location;

/** The activity of the server: its jobs, cycles and profiles (manual, "System"). */
@UrbiTypePart(value = "System", needs = Permission.NOTHING)
final class SystemJobs {
  private final Lobbies lobbies;

  SystemJobs(Lobbies lobbies) {
    this.lobbies = lobbies;
  }

  @Builtin(doc = "Shows the calls that are going on, on the channel backtrace.")
  static void backtrace(Frame frame, UrbiObject self) {
    for (UrbiException.Call call : frame.backtrace()) {
      if (call.name() != null) {
        String place = call.span() == null ? "" : " (" + call.span().location() + ")";
        LobbyType.output(frame).send("backtrace", call.name() + place);
      }
    }
  }

  @Builtin(doc = "Shows all the jobs: what each does, under which tags, called from where.")
  static void ps(Frame frame, UrbiObject self) {
    for (UrbiObject job : SystemType.jobs(frame, self)) {
      frame.interpreter().send(frame, job, "dumpState");
    }
  }

  @Builtin(doc = "Does nothing: what comes from outside is taken at the start of each cycle.")
  static void poll(UrbiObject self) {}

  @Builtin(doc = "The lobbies that are alive, the prototype of lobbies included.")
  List<UrbiObject> lobbies(Frame frame, UrbiObject self) {
    return LobbyType.instances(self.world(), lobbies);
  }

  @Builtin(doc = "The job that runs this code: Job.current.")
  static UrbiObject currentRunner(Frame frame, UrbiObject self) {
    return JobType.current(frame, self);
  }

  @Builtin(doc = "The lobby for which this code runs.")
  static UrbiObject lobby(Frame frame, UrbiObject self) {
    return LobbyType.of(frame);
  }

  @Builtin(
      doc =
          "How many cycles there were since resetStats, and how many seconds they took; nil right"
              + " after it.")
  static UrbiObject stats(Frame frame, UrbiObject self) {
    CycleStatistics statistics = frame.job().scheduler().time().statistics();
    long cycles = frame.job().scheduler().time().cycle() - statistics.since();
    if (cycles == 0) {
      return frame.interpreter().values().nil;
    }
    Map<UrbiDictionary.Key, UrbiObject> entries = new LinkedHashMap<>();
    put(frame, entries, "cycles", cycles);
    put(frame, entries, "cyclesMin", statistics.minimum());
    put(frame, entries, "cyclesMean", statistics.mean());
    put(frame, entries, "cyclesMax", statistics.maximum());
    put(frame, entries, "cyclesVariance", statistics.variance());
    put(frame, entries, "cyclesStdDev", Math.sqrt(statistics.variance()));
    return frame.interpreter().values().dictionary(entries);
  }

  private static void put(
      Frame frame, Map<UrbiDictionary.Key, UrbiObject> entries, String name, double value) {
    entries.put(
        DictionaryKey.of(frame, frame.interpreter().values().string(name)),
        frame.interpreter().values().number(value));
  }

  @Builtin(
      doc =
          "After how many calls code is compiled, how many functions and loops were, how many loops"
              + " count their `;` themselves, how many were refused, and how many bytes they take in"
              + " all.")
  static UrbiObject tier(Frame frame, UrbiObject self) {
    CodeCompiler compiler = frame.interpreter().compiler();
    CodeCompiler.Statistics statistics = compiler.statistics();
    Map<UrbiDictionary.Key, UrbiObject> entries = new LinkedHashMap<>();
    put(frame, entries, "threshold", compiler.threshold());
    put(frame, entries, "functions", statistics.functions());
    put(frame, entries, "loops", statistics.loops());
    put(frame, entries, "counting", statistics.counting());
    put(frame, entries, "refused", statistics.refused());
    put(frame, entries, "bytes", statistics.bytes());
    return frame.interpreter().values().dictionary(entries);
  }

  @Builtin(doc = "Begins to count the cycles anew.", needs = Permission.OWNER)
  static void resetStats(Frame frame, UrbiObject self) {
    frame.job().scheduler().time().statistics().reset(frame.job().scheduler().time().cycle());
  }

  @Builtin(doc = "A new tag that is stopped when the scope around the call is left.")
  static UrbiObject scopeTag(Frame frame, UrbiObject self) {
    return TagType.ofScope(frame);
  }

  @Builtin(doc = "Lets slots be defined again until the end of the scope.")
  static void redefinitionMode(Frame frame, UrbiObject self) {
    Job job = frame.job();
    int before = RedefinitionMode.allowed(job);
    endWithScope(frame, () -> RedefinitionMode.end(job, before));
    RedefinitionMode.allow(job);
  }

  private static void endWithScope(Frame frame, Runnable undo) {
    ScopeEnd end = frame.scopeEnd();
    if (end != null) {
      end.addLast(undo);
    }
  }

  @Builtin(value = "__HERE__", doc = "The position in the source at which it is written.")
  static UrbiObject here(CallSite site, UrbiObject self) {
    if (site.calledSpan() == null) {
      return self.world().prototype("Position");
    }
    Location place = site.calledSpan().location();
    return new Locations(self.world()).position(place.file(), place.line(), place.column());
  }

  @Builtin(
      doc = "Lets no other job run until the end of the scope, which may not wait either.",
      needs = Permission.OWNER)
  static void nonInterruptible(Frame frame, UrbiObject self) {
    Job job = frame.job();
    int before = job.nonInterruptible();
    endWithScope(frame, () -> job.endNonInterruptible(before));
    job.refuseInterruption();
  }

  @Builtin(doc = "Calls a function, and measures what it does.")
  static UrbiObject profile(Frame frame, CallSite site, UrbiObject self, UrbiObject function) {
    Profiler profiler = new Profiler(frame.interpreter());
    profiler.observe(frame.job());
    try {
      frame.interpreter().call(frame, site, function, frame.self());
    } finally {
      profiler.finished(frame.job());
    }
    return new UrbiProfile(self.world().prototype("Profile").cloneShape(), profiler);
  }
}
