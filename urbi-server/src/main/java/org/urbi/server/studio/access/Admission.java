package org.urbi.server.studio.access;

import io.netty.handler.codec.http.QueryStringDecoder;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.time.SystemClock;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.TokenThrottle;
import org.urbi.server.trust.Tokens;

/** Decides who is let in, and as what, by the token in the address that he asks for. */
public final class Admission {
  private final AccessPolicy accessPolicy;
  private final Trace trace;
  private final TokenThrottle wrong = new TokenThrottle(new SystemClock());

  public Admission(AccessPolicy accessPolicy, Trace trace) {
    this.accessPolicy = accessPolicy;
    this.trace = trace;
  }

  /**
   * Lets somebody in.
   *
   * @param uri what he has asked for, perhaps with {@code ?token=TOKEN}
   * @return what he may do
   * @throws Refused if he is not let in
   */
  public Role admit(String uri, SocketAddress from) throws Refused {
    List<String> tokens = new QueryStringDecoder(uri).parameters().getOrDefault("token", List.of());
    if (tokens.isEmpty() || !accessPolicy.asks()) {
      return known(accessPolicy.defaultRole());
    }
    String address = ((InetSocketAddress) from).getAddress().getHostAddress();
    long wait = wrong.secondsToWait(address);
    if (wait > 0) {
      throw new Refused("after a wrong token, no other one for " + wait + " s");
    }
    Tokens.TokenHolder holder = accessPolicy.holder(tokens.getFirst());
    if (holder == null) {
      wrong.recordFailure(address);
      trace.log("studio: wrong token: " + from);
      throw new Refused("wrong token");
    }
    wrong.recordSuccess(address);
    return holder.role();
  }

  private static Role known(@Nullable Role role) throws Refused {
    if (role == null) {
      throw new Refused("this server asks for a token: put ?token=TOKEN behind the address");
    }
    return role;
  }
}
