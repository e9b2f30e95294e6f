package org.urbi.kernel.library.date;

import java.time.DateTimeException;
import java.time.temporal.ChronoField;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.library.value.Printing;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;

/** The parts of dates, which can be assigned (manual, "Date"). */
@UrbiTypePart(value = "Date", needs = Permission.NOTHING)
final class DateParts {
  /** The microseconds in a day. */
  private static final long DAY = 86_400_000_000L;

  private DateParts() {}

  /** Sets one part; all others stay. */
  private static void set(Frame caller, UrbiDate self, ChronoField field, UrbiFloat value) {
    long given = (long) value.value();
    if (given != value.value()) {
      throw invalid(caller, Problem.PART_OF_DATE_NOT_INTEGER, Printing.printable(caller, value));
    }
    if (field == ChronoField.YEAR && (given < 1400 || given > 9999)) {
      throw invalid(caller, Problem.YEAR);
    }
    if (!field.range().isValidValue(given)) {
      throw invalid(caller, Problem.PART_OF_DATE, field, field.range());
    }
    int day = self.dateTime().getDayOfMonth();
    try {
      var changed = self.dateTime().with(field, given);
      // Java would take the last day of a shorter month.
      if (field != ChronoField.DAY_OF_MONTH && changed.getDayOfMonth() != day) {
        throw invalid(caller, Problem.DAY_OF_MONTH);
      }
      self.setDateTime(changed);
    } catch (DateTimeException e) {
      throw invalid(caller, Problem.DAY_OF_MONTH);
    }
  }

  private static UrbiException invalid(Frame caller, Problem problem, Object... values) {
    return caller.interpreter().errors().primitive("updateSlot", problem, values);
  }

  @Builtin(doc = "The year.")
  static int year(UrbiDate self) {
    return self.dateTime().getYear();
  }

  @Builtin(value = "year", setter = true, doc = "Sets the year.", needs = Permission.CHANGE)
  static void setYear(Frame caller, UrbiDate self, UrbiFloat value) {
    set(caller, self, ChronoField.YEAR, value);
  }

  @Builtin(doc = "The month, from 1 to 12.")
  static int month(UrbiDate self) {
    return self.dateTime().getMonthValue();
  }

  @Builtin(value = "month", setter = true, doc = "Sets the month.", needs = Permission.CHANGE)
  static void setMonth(Frame caller, UrbiDate self, UrbiFloat value) {
    set(caller, self, ChronoField.MONTH_OF_YEAR, value);
  }

  @Builtin(doc = "The day in the month, from 1 to 31.")
  static int day(UrbiDate self) {
    return self.dateTime().getDayOfMonth();
  }

  @Builtin(value = "day", setter = true, doc = "Sets the day.", needs = Permission.CHANGE)
  static void setDay(Frame caller, UrbiDate self, UrbiFloat value) {
    set(caller, self, ChronoField.DAY_OF_MONTH, value);
  }

  @Builtin(doc = "The hour, less than 24.")
  static int hour(UrbiDate self) {
    return self.dateTime().getHour();
  }

  @Builtin(value = "hour", setter = true, doc = "Sets the hour.", needs = Permission.CHANGE)
  static void setHour(Frame caller, UrbiDate self, UrbiFloat value) {
    set(caller, self, ChronoField.HOUR_OF_DAY, value);
  }

  @Builtin(doc = "The minute in the hour, less than 60.")
  static int minute(UrbiDate self) {
    return self.dateTime().getMinute();
  }

  @Builtin(value = "minute", setter = true, doc = "Sets the minute.", needs = Permission.CHANGE)
  static void setMinute(Frame caller, UrbiDate self, UrbiFloat value) {
    set(caller, self, ChronoField.MINUTE_OF_HOUR, value);
  }

  @Builtin(doc = "The second in the minute.")
  static int second(UrbiDate self) {
    return self.dateTime().getSecond();
  }

  @Builtin(value = "second", setter = true, doc = "Sets the second.", needs = Permission.CHANGE)
  static void setSecond(Frame caller, UrbiDate self, UrbiFloat value) {
    set(caller, self, ChronoField.SECOND_OF_MINUTE, value);
  }

  @Builtin(doc = "The number of microseconds in the second.")
  static int microsecond(UrbiDate self) {
    return self.dateTime().getNano() / 1000;
  }

  @Builtin(
      value = "microsecond",
      setter = true,
      doc = "Sets the microsecond.",
      needs = Permission.CHANGE)
  static void setMicrosecond(Frame caller, UrbiDate self, UrbiFloat value) {
    set(caller, self, ChronoField.MICRO_OF_SECOND, value);
  }

  @Builtin(doc = "The number of microseconds since midnight.")
  static double us(UrbiDate self) {
    return Math.floorMod(self.microseconds(), DAY);
  }

  @Builtin(
      value = "us",
      setter = true,
      doc = "Sets the number of microseconds since midnight.",
      needs = Permission.CHANGE)
  static void setUs(Frame caller, UrbiDate self, UrbiFloat value) {
    double given = value.value();
    if (given < 0 || given >= DAY) {
      throw invalid(caller, Problem.MICROSECONDS);
    }
    long midnight = Math.floorDiv(self.microseconds(), DAY) * DAY;
    self.setMicroseconds(midnight + (long) given);
  }
}
