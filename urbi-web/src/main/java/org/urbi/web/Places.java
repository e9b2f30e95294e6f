package org.urbi.web;

import io.netty.channel.Channel;
import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * Who is connected to a page: so many who look at it, and as many who have not been let in yet. No
 * address gets all places, and the last ones are for owners: so whoever may help comes in, however
 * many others there are. For the thread that serves them.
 */
public final class Places {
  /** How many may look, and how many besides may wait. */
  static final int ALL = 64;

  /** How many of one address may look. */
  static final int OF_ONE_ADDRESS = 48;

  /** How many of those are for owners only. */
  static final int FOR_OWNERS = 4;

  /** After how many seconds whoever found no place may try again. */
  private static final int AGAIN = 30;

  /** The part of an address in IPv6 that is given to one customer, in bytes. */
  private static final int CUSTOMER = 8;

  private final Set<Channel> waiting = new LinkedHashSet<>();
  private final Set<Channel> looking = new LinkedHashSet<>();

  /** All are free. */
  public Places() {}

  /**
   * Somebody has connected. When all places of those who wait are taken, one of them is closed:
   * otherwise a few that send half a request would lock out everybody else. It is one of the
   * address of which most wait, and of these the one that has waited longest.
   */
  void arrive(Channel channel) {
    if (waiting.size() >= ALL) {
      Map<String, Long> crowds =
          waiting.stream().collect(Collectors.groupingBy(Places::crowd, Collectors.counting()));
      long most = Collections.max(crowds.values());
      waiting.stream()
          .filter(each -> crowds.getOrDefault(crowd(each), 0L) == most)
          .findFirst()
          .ifPresent(Channel::close);
    }
    waiting.add(channel);
    channel.closeFuture().addListener(closed -> waiting.remove(channel));
  }

  /**
   * Gives somebody who may look a place, until the connection is closed.
   *
   * @param owner whether it is one who may do everything
   * @throws Refused if there is none
   */
  public void take(Channel channel, boolean owner) throws Refused {
    int kept = owner ? 0 : FOR_OWNERS;
    if (looking.size() >= ALL - kept) {
      throw new Refused(looking.size() + " look already: there is no place for another one", AGAIN);
    }
    String crowd = crowd(channel);
    long ofThem = looking.stream().filter(each -> crowd(each).equals(crowd)).count();
    if (ofThem >= OF_ONE_ADDRESS - kept && !isThisMachine(channel)) {
      throw new Refused(ofThem + " look already from where you are", AGAIN);
    }
    waiting.remove(channel);
    looking.add(channel);
    channel.closeFuture().addListener(closed -> looking.remove(channel));
  }

  private static @Nullable InetAddress address(Channel channel) {
    return channel.remoteAddress() instanceof InetSocketAddress socket ? socket.getAddress() : null;
  }

  /** Behind an address of this machine there may be a tunnel, by which many come. */
  private static boolean isThisMachine(Channel channel) {
    InetAddress address = address(channel);
    return address != null && address.isLoopbackAddress();
  }

  /** By what those are known who count together. */
  private static String crowd(Channel channel) {
    InetAddress address = address(channel);
    byte[] bytes = address == null ? new byte[0] : address.getAddress();
    return Arrays.toString(
        address instanceof Inet6Address ? Arrays.copyOf(bytes, CUSTOMER) : bytes);
  }
}
