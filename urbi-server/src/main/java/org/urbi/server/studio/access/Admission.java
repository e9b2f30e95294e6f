package org.urbi.server.studio.access;

import io.netty.channel.Channel;
import io.netty.handler.codec.http.QueryStringDecoder;
import java.net.InetSocketAddress;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.TokenThrottle;
import org.urbi.server.trust.Tokens;
import org.urbi.web.Places;
import org.urbi.web.Refused;

/** Decides who is let in, and as what, by the token in the address that he asks for. */
public final class Admission {
  private final AccessPolicy accessPolicy;
  private final Trace trace;
  private final Places places;
  private final TokenThrottle wrong;

  /**
   * @param places of those who are let in
   */
  public Admission(AccessPolicy accessPolicy, Trace trace, Places places) {
    this(accessPolicy, trace, places, new SystemClock());
  }

  Admission(AccessPolicy accessPolicy, Trace trace, Places places, Clock clock) {
    this.accessPolicy = accessPolicy;
    this.trace = trace;
    this.places = places;
    wrong = new TokenThrottle(clock);
  }

  /**
   * Lets somebody in, and gives him a place.
   *
   * @param uri what he has asked for, perhaps with {@code ?token=TOKEN}
   * @return what he may do
   * @throws Refused if he is not let in
   */
  public Role admit(String uri, Channel channel) throws Refused {
    Role role = role(uri, channel);
    places.take(channel, role == Role.OWNER);
    return role;
  }

  private Role role(String uri, Channel channel) throws Refused {
    List<String> tokens = new QueryStringDecoder(uri).parameters().getOrDefault("token", List.of());
    if (tokens.isEmpty() || !accessPolicy.asks()) {
      return known(accessPolicy.defaultRole());
    }
    InetSocketAddress from = (InetSocketAddress) channel.remoteAddress();
    String address = from.getAddress().getHostAddress();
    TokenThrottle.Verdict verdict = wrong.judge(accessPolicy, address, tokens.getFirst());
    Tokens.TokenHolder holder = verdict.holder();
    if (holder == null) {
      if (verdict.isGuess()) {
        trace.log("studio: wrong token: " + from);
      }
      throw new Refused(verdict.reason(), (int) verdict.seconds());
    }
    return holder.role();
  }

  private static Role known(@Nullable Role role) throws Refused {
    if (role == null) {
      throw new Refused("this server asks for a token: put ?token=TOKEN behind the address", 0);
    }
    return role;
  }
}
