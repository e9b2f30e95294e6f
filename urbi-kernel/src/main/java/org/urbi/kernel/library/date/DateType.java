package org.urbi.kernel.library.date;

import java.time.LocalDateTime;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.library.value.Hashing;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Dates (manual, "Date"): making and comparing them. */
@UrbiType(
    value = "Date",
    protos = {"Orderable", "Comparable"},
    doc = "A date in time, to the microsecond.",
    needs = Permission.NOTHING)
final class DateType {
  private DateType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiDate(world.values().object.cloneShape(), 0);
  }

  private static UrbiDate date(Frame caller, long microseconds) {
    return new UrbiDate(caller.interpreter().world().prototype("Date").cloneShape(), microseconds);
  }

  /** The time of this tick, in microseconds since the Epoch. */
  private static long currentMicroseconds(Frame caller) {
    Scheduler scheduler = caller.interpreter().scheduler();
    return Math.round(scheduler.clock().startTime() * 1e6) + scheduler.now() / 1000;
  }

  private static long microseconds(double seconds) {
    return Math.round(seconds * 1e6);
  }

  // ------------------------------------------------------------------ construction

  @Builtin(
      doc = "Makes it the date that the string denotes; the current one without a string.",
      needs = Permission.CHANGE)
  static UrbiDate init(Frame caller, CallSite site, UrbiDate self, @Optional @Nullable String d) {
    if (d == null) {
      self.setMicroseconds(currentMicroseconds(caller));
      return self;
    }
    LocalDateTime parsed = DateParser.parse(d);
    if (parsed == null) {
      throw caller.error(site, Problem.NOT_A_DATE, d);
    }
    self.setDateTime(parsed);
    return self;
  }

  @Builtin(doc = "The current date.")
  static UrbiDate now(Frame caller, UrbiObject self) {
    return date(caller, currentMicroseconds(caller));
  }

  @Builtin(doc = "The origin of times: January 1st 1970, at midnight.")
  static UrbiDate epoch(Frame caller, UrbiObject self) {
    return date(caller, 0);
  }

  // ------------------------------------------------------------------ operators

  @Builtin(value = "+", doc = "The date so many seconds later.")
  static UrbiDate plus(Frame caller, UrbiDate self, double that) {
    return date(caller, self.microseconds() + microseconds(that));
  }

  @Builtin(
      value = "-",
      doc = "The Duration from another date to this one, or the date so many seconds earlier.")
  static UrbiObject minus(Frame caller, CallSite site, UrbiDate self, UrbiObject that) {
    if (that instanceof UrbiDate other) {
      return DurationType.duration(caller, (self.microseconds() - other.microseconds()) / 1e6);
    }
    double seconds = Arguments.number(caller, site, 1, that);
    return date(caller, self.microseconds() - microseconds(seconds));
  }

  @Builtin(value = "==", doc = "Whether that is the same date.")
  static boolean equals(UrbiDate self, UrbiObject that) {
    return that instanceof UrbiDate other && self.microseconds() == other.microseconds();
  }

  @Builtin(value = "<", doc = "Whether it is before that.")
  static boolean less(UrbiDate self, UrbiDate that) {
    return self.microseconds() < that.microseconds();
  }

  @Builtin(doc = "A Hash, equal for equal dates.")
  static UrbiHash hash(Frame caller, UrbiDate self) {
    return Hashing.hash(caller, UrbiHash.mix(6, self.microseconds()));
  }

  // ------------------------------------------------------------------ conversions

  @Builtin(
      value = {"asFloat", "timestamp"},
      doc = "The number of seconds since the epoch.")
  static UrbiFloat asFloat(Frame caller, UrbiDate self) {
    return caller.interpreter().values().number(self.microseconds() / 1e6);
  }

  @Builtin(
      value = {"asString", "asPrintable"},
      doc = "The date, as 2010-08-17 14:40:52.549726.")
  static String asString(UrbiDate self) {
    LocalDateTime d = self.dateTime();
    StringBuilder out = new StringBuilder();
    append(out, d.getYear(), 4, "-");
    append(out, d.getMonthValue(), 2, "-");
    append(out, d.getDayOfMonth(), 2, " ");
    append(out, d.getHour(), 2, ":");
    append(out, d.getMinute(), 2, ":");
    append(out, d.getSecond(), 2, ".");
    append(out, d.getNano() / 1000, 6, "");
    return out.toString();
  }

  private static void append(StringBuilder out, int number, int digits, String after) {
    String text = Integer.toString(number);
    out.append("0".repeat(Math.max(0, digits - text.length()))).append(text).append(after);
  }
}
