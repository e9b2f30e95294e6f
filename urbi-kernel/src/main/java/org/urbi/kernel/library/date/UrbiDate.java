package org.urbi.kernel.library.date;

import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import java.time.temporal.ChronoUnit;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A moment, to the microsecond (manual, "Date"); in universal time. */
public final class UrbiDate extends UrbiObject {
  private long microseconds;

  /**
   * @param microseconds since the Epoch
   */
  public UrbiDate(Shape shape, long microseconds) {
    super(shape);
    this.microseconds = microseconds;
  }

  /** Microseconds since the Epoch. */
  long microseconds() {
    noteContentRead();
    return microseconds;
  }

  void setMicroseconds(long other) {
    microseconds = other;
    noteContentChange();
  }

  LocalDateTime dateTime() {
    return LocalDateTime.ofInstant(
        Instant.EPOCH.plus(microseconds(), ChronoUnit.MICROS), ZoneOffset.UTC);
  }

  void setDateTime(LocalDateTime other) {
    setMicroseconds(microseconds(other));
  }

  /** Microseconds from the Epoch to a date. */
  static long microseconds(LocalDateTime date) {
    return date.toEpochSecond(ZoneOffset.UTC) * 1_000_000L + date.getNano() / 1000;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiDate(cloneShape(), microseconds);
  }
}
