package org.urbi.ros.rtps;

import java.net.InetSocketAddress;

/** What the writers and readers of a participant share, guarded by its lock. */
final class Environment {
  final GuidPrefix prefix;
  final ParticipantOptions options;
  final Reactor reactor;
  final MessageBuilder message;
  final MemoryBudget halfReceived;
  private final DatagramSink sink;

  Environment(GuidPrefix prefix, ParticipantOptions options, Reactor reactor, DatagramSink sink) {
    this.prefix = prefix;
    this.options = options;
    this.reactor = reactor;
    this.sink = sink;
    message = new MessageBuilder(prefix);
    halfReceived = new MemoryBudget(options.memory());
  }

  /** Sends what has been built. */
  void send(InetSocketAddress to) {
    sink.send(message.finish().duplicate(), to);
  }

  /** Sends what has been built to all of them. */
  void send(InetSocketAddress[] addresses) {
    var datagram = message.finish();
    for (InetSocketAddress each : addresses) sink.send(datagram.duplicate(), each);
  }
}
