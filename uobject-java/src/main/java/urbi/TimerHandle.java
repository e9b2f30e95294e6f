package urbi;

import java.util.Objects;

/** A timer that {@link UObject#USetTimer} has set, to be given to {@link UObject#removeTimer}. */
public final class TimerHandle {
  private final String name;

  private TimerHandle(String name) {
    this.name = Objects.requireNonNull(name, "name");
  }

  /** The timer of a name that {@link UObject#USetTimer} has returned. */
  public static TimerHandle create(String name) {
    return new TimerHandle(name);
  }

  String name() {
    return name;
  }

  @Override
  public String toString() {
    return name;
  }
}
