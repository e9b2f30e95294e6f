package org.urbi.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.channel.embedded.EmbeddedChannel;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Who gets a place when there are more than there are places. */
class PlacesTest {
  private final Places places = new Places();
  private final List<EmbeddedChannel> channels = new ArrayList<>();

  @AfterEach
  void close() {
    channels.forEach(EmbeddedChannel::finishAndReleaseAll);
  }

  /** Somebody comes from an address. */
  private EmbeddedChannel come(String address) throws UnknownHostException {
    InetAddress from = InetAddress.getByName(address);
    EmbeddedChannel channel =
        new EmbeddedChannel() {
          @Override
          protected SocketAddress remoteAddress0() {
            return new InetSocketAddress(from, 1);
          }
        };
    channels.add(channel);
    places.arrive(channel);
    return channel;
  }

  /** How many of those who come from an address, one after the other, find a place. */
  private int enter(String address, boolean owner) throws UnknownHostException {
    for (int count = 0; true; count++) {
      EmbeddedChannel next = come(address);
      try {
        places.take(next, owner);
      } catch (Refused e) {
        assertEquals(30, e.again());
        next.close();
        return count;
      }
    }
  }

  @Test
  void oneAddressDoesNotGetAllPlaces() throws Exception {
    assertEquals(44, enter("10.0.0.1", false));
    assertEquals(4, enter("10.0.0.1", true), "the last ones are for owners");
    assertEquals(12, enter("10.0.0.2", false));
    assertEquals(0, enter("10.0.0.3", false));
    assertEquals(4, enter("10.0.0.3", true));
    EmbeddedChannel late = come("10.0.0.4");
    String why = assertThrows(Refused.class, () -> places.take(late, true)).getMessage();
    assertEquals("64 look already: there is no place for another one", why);
  }

  @Test
  void addressesOfOneCustomerAreOne() throws Exception {
    assertEquals(44, enter("2001:db8::1", false));
    EmbeddedChannel same = come("2001:db8::ffff:1:2");
    String why = assertThrows(Refused.class, () -> places.take(same, false)).getMessage();
    assertEquals("44 look already from where you are", why);
    assertEquals(16, enter("2001:db8:0:1::1", false));
  }

  @Test
  void tunnelOfThisMachineMayHaveAll() throws Exception {
    assertEquals(60, enter("127.0.0.1", false));
    assertEquals(4, enter("127.0.0.1", true));
  }

  @Test
  void placeOfWhoeverLeavesIsFree() throws Exception {
    assertEquals(64, enter("127.0.0.1", true));
    channels.get(7).close();
    assertEquals(1, enter("127.0.0.1", true));
  }

  @Test
  void crowdThatIsNotLetInMakesRoomForOthers() throws Exception {
    EmbeddedChannel patient = come("10.0.0.2");
    EmbeddedChannel looks = come("10.0.0.1");
    places.take(looks, false);
    for (int i = 0; i < 1000; i++) {
      come("10.0.0.1");
    }
    assertTrue(patient.isOpen(), "the one who has waited longest is of another address");
    assertTrue(looks.isOpen(), "whoever has been let in stays");
    assertTrue(channels.getLast().isOpen(), "whoever comes now is heard");
    assertEquals(65, channels.stream().filter(EmbeddedChannel::isOpen).count());
    assertFalse(channels.get(2).isOpen(), "the one of them who has waited longest");
  }
}
