package org.urbi.server.studio.access;

import static org.junit.jupiter.api.Assertions.assertEquals;

import io.netty.channel.embedded.EmbeddedChannel;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.time.VirtualClock;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.Tokens;
import org.urbi.web.Places;
import org.urbi.web.Refused;

/** Who is let in by which token, and when, in virtual time. */
class AdmissionTest {
  private static final String RIGHT = "0123456789abcdef";
  private static final String WRONG = "wrong token, again 0";
  private static final long SECOND = 1_000_000_000L;

  private final VirtualClock clock = new VirtualClock();
  private final Admission admission =
      new Admission(
          new AccessPolicy(Tokens.single(RIGHT, Role.OBSERVER, "visitor"), null),
          new Trace(
              Trace.Level.NONE,
              new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8)),
          new Places(),
          clock);

  /** What somebody is told who shows a token at an address. */
  private String show(String token, String address) {
    EmbeddedChannel channel =
        new EmbeddedChannel() {
          @Override
          protected SocketAddress remoteAddress0() {
            return new InetSocketAddress(address, 1);
          }
        };
    try {
      return admission.admit("/stream?token=" + token, channel).text();
    } catch (Refused e) {
      return e.getMessage() + ", again " + e.again();
    } finally {
      channel.finishAndReleaseAll();
    }
  }

  private void pass(long seconds) {
    clock.advanceTo(clock.now() + seconds * SECOND);
  }

  @Test
  void tokenIsNotGuessedQuickly() {
    assertEquals(WRONG, show("guess", "10.0.0.1"));
    assertEquals(
        "after a wrong token, no other one for 1 s, again 1",
        show(RIGHT, "10.0.0.1"),
        "otherwise one could guess without waiting");
    assertEquals("observer", show(RIGHT, "10.0.0.2"));
    pass(1);
    assertEquals(WRONG, show("another", "10.0.0.1"));
    pass(1);
    assertEquals("after a wrong token, no other one for 1 s, again 1", show("third", "10.0.0.1"));
    pass(1);
    assertEquals("observer", show(RIGHT, "10.0.0.1"));
  }

  /** A page that goes on with an old token locks out nobody who has a right one. */
  @Test
  void sameWrongTokenIsNoOtherGuess() {
    assertEquals(WRONG, show("outdated", "10.0.0.1"));
    for (int i = 0; i < 100; i++) {
      pass(1);
      assertEquals(WRONG, show("outdated", "10.0.0.1"));
      assertEquals("observer", show(RIGHT, "10.0.0.1"));
    }
  }
}
