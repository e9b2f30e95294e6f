package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.urbi.ros.time.SteadyClock;

/**
 * The datagram that is being put together. What goes to the same addresses goes in the same one:
 * the samples of a writer that has many, or an acknowledgement and what is said in reply. It leaves
 * when the lock is left, so that nothing alone ever waits; only samples of those who have just sent
 * some wait for more, for a moment. The lock of the participant guards it.
 */
final class Outbox {
  /**
   * Whoever writes twice within so many nanoseconds is expected to write more: single samples do
   * not follow each other so fast.
   */
  private static final long SOON = 15_000;

  /** How long samples wait for more at most, in nanoseconds. */
  private static final long LATEST = 200_000;

  private final MessageBuilder message;
  private final DatagramSink sink;
  private final int largest;
  private final Reactor.Timer timer;

  /** The writers of samples in it, which end it by saying what there is. */
  private final List<StatefulWriter> writers = new ArrayList<>();

  private InetSocketAddress[] addresses = {};
  private GuidPrefix destination = GuidPrefix.UNKNOWN;
  private boolean isOpen;
  private boolean isUrgent;
  private long sent = SteadyClock.nanoseconds() - SOON;

  /** {@code largest}: how many bytes the datagrams have at most that contain several things. */
  Outbox(GuidPrefix own, Reactor reactor, DatagramSink sink, int largest) {
    this.sink = sink;
    this.largest = largest;
    message = new MessageBuilder(own);
    timer = reactor.timer("sending", this::flush);
  }

  /** Where to put a submessage of so many bytes, at most, that concerns one participant. */
  MessageBuilder to(InetSocketAddress address, GuidPrefix receiver, int bytes) {
    return to(new InetSocketAddress[] {address}, receiver, bytes);
  }

  /** Where to put one that concerns {@code receiver}, or all if that is not known. */
  MessageBuilder to(InetSocketAddress[] where, GuidPrefix receiver, int bytes) {
    MessageBuilder opened = open(where, receiver, bytes);
    isUrgent = true;
    return opened;
  }

  /** Where to put a sample; {@link StatefulWriter#announce} ends the datagram. */
  MessageBuilder sample(
      StatefulWriter writer, InetSocketAddress[] where, GuidPrefix receiver, int bytes) {
    MessageBuilder opened = open(where, receiver, bytes + MessageBuilder.HEARTBEAT_SIZE);
    if (!writers.contains(writer)) writers.add(writer);
    return opened;
  }

  private MessageBuilder open(InetSocketAddress[] where, GuidPrefix receiver, int bytes) {
    int all = bytes + writers.size() * MessageBuilder.HEARTBEAT_SIZE;
    boolean fits = message.size() + all <= largest;
    if (isOpen && !(fits && destination.equals(receiver) && Arrays.equals(addresses, where)))
      flush();
    if (!isOpen) {
      isOpen = true;
      addresses = where;
      destination = receiver;
      if (receiver.equals(GuidPrefix.UNKNOWN)) message.begin();
      else message.begin(receiver);
    }
    return message;
  }

  /** The lock is about to be left: what need not wait is sent. */
  void leave() {
    if (!isOpen) return;
    if (isUrgent || SteadyClock.nanoseconds() - sent > SOON) flush();
    else if (!timer.isSet()) timer.in(LATEST);
  }

  /** Sends what there is. */
  void flush() {
    if (!isOpen) return;
    for (StatefulWriter each : writers) each.announce(message);
    writers.clear();
    isOpen = false;
    isUrgent = false;
    var datagram = message.finish();
    for (InetSocketAddress each : addresses) sink.send(datagram.duplicate(), each);
    sent = SteadyClock.nanoseconds();
  }
}
