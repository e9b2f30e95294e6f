package org.urbi.server.trust;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.urbi.kernel.time.Clock;

/**
 * Delays clients after wrong tokens, so that nobody can try many: after each wrong token its
 * address has to wait, twice as long each time, also with a right one: otherwise to guess would
 * cost no time. To show the same wrong token once more is no other guess: a client that does not
 * know better locks nobody else out for that. Not thread-safe.
 */
public final class TokenThrottle {
  private static final long FIRST_WAIT = 1_000_000_000L;
  private static final int MAX_DOUBLINGS = 6;
  private static final int MAX_ADDRESSES = 4096;

  /** How many wrong tokens of an address are remembered. */
  private static final int MAX_TOKENS = 4;

  /**
   * An address.
   *
   * @param failures since the last right token; those that lengthen the wait
   * @param tokens the last wrong ones, by their digests
   */
  private record Offender(int failures, long until, List<String> tokens) {
    static final Offender NEW = new Offender(0, Long.MIN_VALUE, List.of());
  }

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
    long now = clock.now();
    return offender == null || offender.until <= now
        ? 0
        : (offender.until - now - 1) / FIRST_WAIT + 1;
  }

  /** Whether that address has shown that token not long ago, and it was wrong. */
  public boolean isKnown(String address, String token) {
    Offender offender = offenders.get(address);
    return offender != null && offender.tokens.contains(Tokens.digest(token));
  }

  /** Records a wrong token from that address. */
  public void recordFailure(String address, String token) {
    Offender before = Objects.requireNonNullElse(offenders.remove(address), Offender.NEW);
    List<String> tokens = new ArrayList<>(before.tokens);
    tokens.add(Tokens.digest(token));
    if (tokens.size() > MAX_TOKENS) {
      tokens.removeFirst();
    }
    long until = clock.now() + (FIRST_WAIT << before.failures);
    int failures = Math.min(before.failures + 1, MAX_DOUBLINGS);
    offenders.put(address, new Offender(failures, until, tokens));
  }

  /** After a right token that address does not have to wait, and begins anew. */
  public void recordSuccess(String address) {
    offenders.computeIfPresent(
        address, (same, known) -> new Offender(0, Long.MIN_VALUE, known.tokens));
  }
}
