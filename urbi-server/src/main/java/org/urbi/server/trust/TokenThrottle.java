package org.urbi.server.trust;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
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

  /**
   * What comes of a token that somebody has shown.
   *
   * @param holder whose it is; null if it is refused
   * @param seconds for how many seconds no other one is looked at; 0 if it is wrong, or right
   * @param isGuess whether it is wrong, and was not known to be
   */
  public record Verdict(Tokens.@Nullable TokenHolder holder, long seconds, boolean isGuess) {
    /** Why it is refused. */
    public String reason() {
      return seconds > 0 ? Problem.TOKEN_TOO_SOON.text(seconds) : Problem.WRONG_TOKEN.text();
    }
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

  /** Judges a token that was shown from an address, and remembers what has come of it. */
  public Verdict judge(AccessPolicy accessPolicy, String address, String token) {
    if (isKnown(address, token)) {
      return new Verdict(null, 0, false);
    }
    long wait = secondsToWait(address);
    if (wait > 0) {
      return new Verdict(null, wait, false);
    }
    Tokens.TokenHolder holder = accessPolicy.holder(token);
    if (holder == null) {
      recordFailure(address, token);
    } else {
      recordSuccess(address);
    }
    return new Verdict(holder, 0, holder == null);
  }

  /** For how many seconds that address still has to wait; 0 for none. */
  long secondsToWait(String address) {
    Offender offender = offenders.get(address);
    long now = clock.now();
    return offender == null || offender.until <= now
        ? 0
        : (offender.until - now - 1) / FIRST_WAIT + 1;
  }

  /** Whether that address has shown that token not long ago, and it was wrong. */
  boolean isKnown(String address, String token) {
    Offender offender = offenders.get(address);
    return offender != null && offender.tokens.contains(Tokens.digest(token));
  }

  /** Records a wrong token from that address. */
  void recordFailure(String address, String token) {
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
  void recordSuccess(String address) {
    offenders.computeIfPresent(
        address, (same, known) -> new Offender(0, Long.MIN_VALUE, known.tokens));
  }
}
