package org.urbi.ros.rtps;

/** What the writers and readers of a participant share, guarded by its lock. */
final class Environment {
  /**
   * How many bytes a datagram has at most on a network, where it is lost with any of its pieces.
   * Other implementations have the same limit.
   */
  private static final int LARGEST_ON_A_NETWORK = 14_720;

  final GuidPrefix prefix;
  final ParticipantOptions options;
  final Reactor reactor;
  final Outbox outbox;
  final MemoryBudget halfReceived;

  Environment(GuidPrefix prefix, ParticipantOptions options, Reactor reactor, DatagramSink sink) {
    this.prefix = prefix;
    this.options = options;
    this.reactor = reactor;
    int largest = options.fragmentSize() + MessageBuilder.OVERHEAD;
    if (!options.address().isLoopbackAddress()) largest = Math.min(largest, LARGEST_ON_A_NETWORK);
    outbox = new Outbox(prefix, reactor, sink, largest);
    halfReceived = new MemoryBudget(options.memory());
    reactor.beforeLeaving(outbox::leave);
  }
}
