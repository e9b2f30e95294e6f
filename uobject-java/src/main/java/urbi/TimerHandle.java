package urbi;

/** A timer that {@link UObject#USetTimer} has set, to be given to {@link UObject#removeTimer}. */
public final class TimerHandle {
  private final Runnable end;

  TimerHandle(Runnable end) {
    this.end = end;
  }

  void end() {
    end.run();
  }
}
