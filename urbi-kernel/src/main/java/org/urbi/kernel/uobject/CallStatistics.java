package org.urbi.kernel.uobject;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.CallTimes;

/** Counts and times the calls of functions of UObjects, while that is enabled. */
public final class CallStatistics {
  /** The calls of one function. */
  final class Entry {
    private final String function;
    private @Nullable CallTimes times;

    Entry(String function) {
      this.function = function;
    }

    /** A call begins. */
    long begin() {
      if (trace != null) {
        trace.accept("uobjects: " + function);
      }
      return enabled ? clock.getAsLong() : 0;
    }

    /** A call ends that began then. */
    void end(long started) {
      if (enabled) {
        if (times == null) {
          times = called.computeIfAbsent(function, name -> new CallTimes());
        }
        times.add(clock.getAsLong() - started);
      }
    }
  }

  private final LongSupplier clock;
  private final Map<String, CallTimes> called = new LinkedHashMap<>();
  private @Nullable Consumer<String> trace;
  private boolean enabled;

  CallStatistics(LongSupplier clock) {
    this.clock = clock;
  }

  /** The calls of the function of that name. */
  Entry entry(String function) {
    return new Entry(function);
  }

  /** The calls of that function are no longer of interest. */
  void forget(String function) {
    called.remove(function);
  }

  public void enable(boolean on) {
    enabled = on;
  }

  /** Sets a consumer that gets the name of each called function; null for none. */
  public void trace(@Nullable Consumer<String> told) {
    trace = told;
  }

  public void clear() {
    called.values().forEach(CallTimes::reset);
  }

  /** The times of all functions that were called. */
  public Map<String, CallTimes> all() {
    Map<String, CallTimes> all = new LinkedHashMap<>();
    called.forEach((name, times) -> {
      if (times.count() > 0) {
        all.put(name, times);
      }
    });
    return all;
  }
}
