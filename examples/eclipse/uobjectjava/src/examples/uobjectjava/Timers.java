package examples.uobjectjava;

import urbi.UObject;
import urbi.UVar;

/**
 * Does something again and again: {@code update}, and a timer, which it removes after three times.
 */
public class Timers extends UObject {
  static {
    UStart(Timers.class);
  }

  private static final double PERIOD_MILLISECONDS = 10;
  private static final int ENOUGH = 3;

  private final UVar updates = new UVar();
  private final UVar ticks = new UVar();
  private String timer;

  public Timers(String name) {
    super(name);
    UBindFunction("init");
  }

  public void init() {
    UBindVars(updates, "updates", ticks, "ticks");
    updates.setValue(0);
    ticks.setValue(0);
    USetUpdate(PERIOD_MILLISECONDS);
    timer = USetTimer(PERIOD_MILLISECONDS, this, "tick");
  }

  @Override
  public int update() {
    updates.setValue(updates.intValue() + 1);
    return 0;
  }

  public void tick() {
    int count = ticks.intValue() + 1;
    ticks.setValue(count);
    if (count == ENOUGH) {
      removeTimer(timer);
    }
  }
}
