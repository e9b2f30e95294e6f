package org.urbi.ros.rtps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.net.StandardProtocolFamily;
import java.nio.channels.AlreadyBoundException;
import java.nio.channels.DatagramChannel;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a participant that cannot have all its sockets leaves behind. */
class UdpTransportTest {
  private static final InetAddress LOOPBACK = InetAddress.ofLiteral("127.0.0.1");

  private final List<DatagramChannel> opened = new ArrayList<>();
  private Neighbourhood domain;

  @BeforeEach
  void choose() throws Exception {
    domain = new Neighbourhood();
  }

  @AfterEach
  void end() throws Exception {
    domain.close();
  }

  private DatagramChannel socket() throws IOException {
    DatagramChannel channel = DatagramChannel.open(StandardProtocolFamily.INET);
    opened.add(channel);
    return channel;
  }

  private UdpTransport transport(UdpTransport.Opener opener) throws IOException {
    return new UdpTransport(domain.domain(), LOOPBACK, (what, why) -> {}, opener);
  }

  private void assertNoneIsOpen() {
    assertTrue(opened.stream().noneMatch(DatagramChannel::isOpen), opened::toString);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void whereNoDescriptorIsLeftNoneIsKept(int left) {
    IOException refused =
        assertThrows(
            IOException.class,
            () ->
                transport(() -> {
                  if (opened.size() == left) throw new SocketException("Too many open files");
                  return socket();
                }));
    assertEquals("Too many open files", refused.getMessage());
    assertEquals(left, opened.size());
    assertNoneIsOpen();
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void whatGoesWrongInAnUnexpectedWayLeavesNoneEither(int good) {
    assertThrows(
        AlreadyBoundException.class,
        () ->
            transport(() -> {
              boolean usual = opened.size() < good;
              DatagramChannel channel = socket();
              return usual ? channel : channel.bind(new InetSocketAddress(LOOPBACK, 0));
            }));
    assertEquals(good + 1, opened.size());
    assertNoneIsOpen();
  }

  @Test
  void portsThatOthersHaveCostNoSocket() throws Exception {
    UdpTransport first = transport(this::socket);
    assertEquals(3, opened.size());
    opened.clear();
    UdpTransport second = transport(this::socket);
    assertEquals(3, opened.stream().filter(DatagramChannel::isOpen).count());
    second.close();
    assertNoneIsOpen();
    first.close();
  }

  @Test
  void withoutAnInterfaceNothingIsOpened() {
    IOException refused =
        assertThrows(
            IOException.class,
            () ->
                new UdpTransport(
                    domain.domain(),
                    InetAddress.ofLiteral("192.0.2.1"),
                    (what, why) -> {},
                    this::socket));
    assertEquals("no network interface has the address 192.0.2.1", refused.getMessage());
    assertFalse(opened.iterator().hasNext());
  }
}
