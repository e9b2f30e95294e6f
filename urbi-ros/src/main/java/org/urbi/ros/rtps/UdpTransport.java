package org.urbi.ros.rtps;

import java.io.Closeable;
import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import urbi.thread.GuardedThreads;

/** The sockets of a participant, and the thread that receives from them. */
final class UdpTransport implements DatagramSink {
  /** What arrives. */
  interface Receiver {
    void received(ByteBuffer datagram, InetSocketAddress from);
  }

  /** Where sockets come from. */
  interface Opener {
    DatagramChannel open() throws IOException;
  }

  private record Pair(DatagramChannel discovery, DatagramChannel user) {}

  /** How many others a participant without multicast looks for, as other implementations do. */
  static final int PARTICIPANTS_LOOKED_FOR = 32;

  private static final int LAST_INDEX = 119;
  private static final int BUFFER = 4 << 20;
  private static final InetAddress GROUP = InetAddress.ofLiteral("239.255.0.1");

  /** Asking the system about an address costs much more than a datagram. */
  private static final int ADDRESSES_KNOWN = 1000;

  private final Map<InetAddress, Boolean> ofThisMachine = new ConcurrentHashMap<>();
  private final int domain;
  private final InetAddress address;
  private final NetworkInterface network;
  private final BiConsumer<String, Throwable> trouble;
  private final Opener opener;
  private final List<Closeable> opened = new ArrayList<>();
  private final Selector selector;
  private final DatagramChannel discovery;
  private final DatagramChannel user;
  private final DatagramChannel multicast;
  private final InetSocketAddress multicastAddress;

  /**
   * Opens the sockets.
   *
   * @throws IOException if the machine has no such address, or no port is left in the domain
   */
  UdpTransport(int domain, InetAddress address, BiConsumer<String, Throwable> trouble)
      throws IOException {
    this(domain, address, trouble, () -> DatagramChannel.open(StandardProtocolFamily.INET));
  }

  /** With sockets from elsewhere. */
  UdpTransport(
      int domain, InetAddress address, BiConsumer<String, Throwable> trouble, Opener opener)
      throws IOException {
    this.domain = domain;
    this.address = address;
    this.trouble = trouble;
    this.opener = opener;
    NetworkInterface found = NetworkInterface.getByInetAddress(address);
    if (found == null)
      throw new IOException("no network interface has the address " + address.getHostAddress());
    network = found;
    multicastAddress = new InetSocketAddress(GROUP, port(domain, 0));
    selector = Selector.open();
    opened.add(selector);
    try {
      Pair pair = pair();
      discovery = pair.discovery;
      user = pair.user;
      multicast = joined();
      for (DatagramChannel channel : List.of(discovery, user, multicast))
        channel.register(selector, SelectionKey.OP_READ);
    } catch (IOException | RuntimeException | Error e) {
      // Of the last files that a process may open, none is kept for nothing.
      close();
      throw e;
    }
  }

  /** Two sockets at the first two ports that are free of those that participants have. */
  private Pair pair() throws IOException {
    for (int index = 0; index <= LAST_INDEX; index++) {
      DatagramChannel first = bound(discoveryPort(domain, index));
      if (first == null) continue;
      DatagramChannel second = bound(discoveryPort(domain, index) + 1);
      if (second != null) return new Pair(first, second);
      forsake(first);
    }
    throw new IOException("no port is left for a participant of domain " + domain);
  }

  private static int port(int domain, int offset) {
    return 7400 + 250 * domain + offset;
  }

  private static int discoveryPort(int domain, int index) {
    return port(domain, 10 + 2 * index);
  }

  private DatagramChannel open() throws IOException {
    DatagramChannel channel = opener.open();
    opened.add(channel);
    channel.configureBlocking(false);
    channel.setOption(StandardSocketOptions.SO_RCVBUF, BUFFER);
    channel.setOption(StandardSocketOptions.SO_SNDBUF, BUFFER);
    return channel;
  }

  private @Nullable DatagramChannel bound(int port) throws IOException {
    DatagramChannel channel = open();
    try {
      channel.setOption(StandardSocketOptions.IP_MULTICAST_IF, network);
      return channel.bind(new InetSocketAddress(address, port));
    } catch (BindException e) {
      forsake(channel);
      return null;
    }
  }

  private void forsake(DatagramChannel channel) throws IOException {
    opened.remove(channel);
    channel.close();
  }

  private DatagramChannel joined() throws IOException {
    DatagramChannel channel = open();
    channel.setOption(StandardSocketOptions.SO_REUSEADDR, true);
    try {
      channel.bind(multicastAddress);
    } catch (IOException e) {
      // Not every system lets a socket have the address of a group.
      channel.bind(new InetSocketAddress(multicastAddress.getPort()));
    }
    try {
      channel.join(GROUP, network);
    } catch (IOException e) {
      trouble.accept(
          "no multicast on " + network.getName() + ", only nodes of this machine are found", e);
    }
    return channel;
  }

  /** Where other participants send what is about discovery. */
  InetSocketAddress discoveryAddress() throws IOException {
    return (InetSocketAddress) discovery.getLocalAddress();
  }

  /** Where other participants send samples. */
  InetSocketAddress userAddress() throws IOException {
    return (InetSocketAddress) user.getLocalAddress();
  }

  InetSocketAddress multicastAddress() {
    return multicastAddress;
  }

  /** Where the n-th participant of this machine listens, whether it exists or not. */
  InetSocketAddress neighbour(int index) {
    return new InetSocketAddress(address, discoveryPort(domain, index));
  }

  /**
   * Whether this participant speaks with that address: one that is bound to loopback only with its
   * machine.
   */
  boolean accepts(InetAddress other) {
    if (!address.isLoopbackAddress() || other.isLoopbackAddress()) return true;
    if (ofThisMachine.size() > ADDRESSES_KNOWN) ofThisMachine.clear();
    return ofThisMachine.computeIfAbsent(other, UdpTransport::isOfThisMachine);
  }

  private static boolean isOfThisMachine(InetAddress other) {
    try {
      return NetworkInterface.getByInetAddress(other) != null;
    } catch (IOException e) {
      return false;
    }
  }

  /** What receives, not started yet. */
  Thread receiving(String name, Receiver receiver) {
    return GuardedThreads.SDK.platform(name, () -> receive(receiver));
  }

  private void receive(Receiver receiver) {
    ByteBuffer buffer = ByteBuffer.allocateDirect(1 << 16);
    while (selector.isOpen()) {
      try {
        selector.select(key -> drain((DatagramChannel) key.channel(), buffer, receiver));
      } catch (ClosedSelectorException e) {
        return;
      } catch (Throwable e) {
        trouble.accept("receiving failed", e);
      }
    }
  }

  private void drain(DatagramChannel channel, ByteBuffer buffer, Receiver receiver) {
    // So many at once, that one socket which is flooded does not silence the others.
    for (int i = 0; i < 64; i++) {
      try {
        InetSocketAddress from = (InetSocketAddress) channel.receive(buffer.clear());
        if (from == null) return;
        if (accepts(from.getAddress())) receiver.received(buffer.flip(), from);
      } catch (IOException e) {
        // That nobody listens at an address that was sent to: leases and acknowledgements tell it
        // better.
        return;
      } catch (Throwable e) {
        trouble.accept("a datagram could not be handled", e);
      }
    }
  }

  @Override
  public void send(ByteBuffer datagram, InetSocketAddress to) {
    try {
      user.send(datagram, to);
    } catch (IOException e) {
      // As good as lost on its way: what has to arrive is sent again.
      trouble.accept("cannot send to " + to, e);
    }
  }

  /** Closes the sockets; its thread ends. */
  void close() {
    for (Closeable each : opened) {
      try {
        each.close();
      } catch (IOException e) {
        trouble.accept("cannot close", e);
      }
    }
  }
}
