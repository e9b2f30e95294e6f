package org.urbi.server.trust;

import java.util.LinkedHashMap;
import java.util.Map;
import org.urbi.kernel.time.Clock;

/**
 * Delays clients after wrong tokens, so that nobody can try many: after each wrong token its
 * address has to wait, twice as long each time. Not thread-safe.
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

  /** For how many seconds that address still has to wait; 0 for none. */
  public long secondsToWait(String address) {
    Offender offender = offenders.get(address);
    long left = offender == null ? 0 : offender.until - clock.now();
    return left <= 0 ? 0 : (left - 1) / FIRST_WAIT + 1;
  }

  /** Records a wrong token from that address. */
  public void recordFailure(String address) {
    Offender known = offenders.remove(address);
    int count = known == null ? 0 : Math.min(known.count + 1, MAX_DOUBLINGS);
    offenders.put(address, new Offender(count, clock.now() + (FIRST_WAIT << count)));
  }

  /** Forgets the wrong tokens of that address after a right one. */
  public void recordSuccess(String address) {
    offenders.remove(address);
  }
}
