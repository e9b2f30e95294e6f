package org.urbi.server.trust;

import java.util.LinkedHashMap;
import java.util.Map;
import org.urbi.kernel.time.Clock;

/**
 * Those who have shown wrong tokens, so that nobody tries them all: each wrong one has its address
 * wait before the next one is looked at, twice as long each time. On one thread.
 */
public final class TokenThrottle {
  private static final long FIRST_WAIT = 1_000_000_000L;
  private static final int MAX_DOUBLINGS = 6;
  private static final int MAX_ADDRESSES = 4096;

  private record Offender(int count, long until) {}

  private final Clock clock;
  private final Map<String, Offender> offenders =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Offender> eldest) {
          return size() > MAX_ADDRESSES;
        }
      };

  public TokenThrottle(Clock clock) {
    this.clock = clock;
  }

  /** For how many seconds nothing from there is looked at; 0 if it is. */
  public long secondsToWait(String address) {
    Offender offender = offenders.get(address);
    long left = offender == null ? 0 : offender.until - clock.now();
    return left <= 0 ? 0 : (left - 1) / FIRST_WAIT + 1;
  }

  /** Somebody has shown a wrong token. */
  public void note(String address) {
    Offender known = offenders.remove(address);
    int count = known == null ? 0 : Math.min(known.count + 1, MAX_DOUBLINGS);
    offenders.put(address, new Offender(count, clock.now() + (FIRST_WAIT << count)));
  }

  /** Somebody there has shown one that is right. */
  public void forgive(String address) {
    offenders.remove(address);
  }
}
