package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.journal.StopReason;

/** A loop whose jobs themselves move the machine's clock, and what its watchdog is told. */
abstract class WatchedLoop {
  static final long LIMIT = 1_000;

  final Loop loop = new Loop();

  /** Of the kernel thread; by default nobody knows it. */
  long processorTime = HoldWatchdog.UNKNOWN;

  /** By the kernel thread, in bytes. */
  long allocated = 1_000_000;

  /** Of the process, in bytes. */
  long free = Long.MAX_VALUE;

  final List<String> told = new ArrayList<>();
  final HoldWatchdog watch =
      new HoldWatchdog(
          loop.scheduler,
          loop.machine,
          new HoldWatchdog.Gauges(() -> processorTime, () -> allocated, () -> free, 3_200_000),
          LIMIT,
          (job, component, why, limit) ->
              told.add(
                  job.name()
                      + " "
                      + component
                      + (why == StopReason.GREEDY ? " of " + limit + " bytes" : "")));

  void lookAt(long time) {
    loop.machine.now = time;
    watch.check();
  }

  void lookAt(long time, long processor) {
    processorTime = processor;
    lookAt(time);
  }

  void lookWith(long bytes) {
    allocated = bytes;
    watch.check();
  }
}
