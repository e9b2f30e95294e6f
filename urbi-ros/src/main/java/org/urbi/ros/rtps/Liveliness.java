package org.urbi.ros.rtps;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;

/** Tells others that the writers of this participant live, and hears the same of theirs. */
final class Liveliness implements SampleSink {
  private static final int AUTOMATIC = 1;
  private static final int MANUAL = 2;
  private static final int PLAIN_BIG_ENDIAN = 0;

  private final Environment environment;
  private final StatefulWriter writer;
  private final Matching matching;
  private final Routes routes;
  private final Reactor.Timer timer;

  Liveliness(Environment environment, StatefulWriter writer, Matching matching, Routes routes) {
    this.environment = environment;
    this.writer = writer;
    this.matching = matching;
    this.routes = routes;
    timer = environment.reactor.timer("liveliness", this::assertAutomatic);
  }

  /** There is another writer, whose participant may have to vouch for it. */
  void added(EndpointInfo info) {
    if (isAutomatic(info)) timer.atLatestIn(info.qos().lease() / 3);
  }

  private static boolean isAutomatic(EndpointInfo info) {
    EndpointQos qos = info.qos();
    return info.isWriter()
        && qos.liveliness() == EndpointQos.Liveliness.AUTOMATIC
        && qos.lease() != EndpointQos.INFINITE;
  }

  private void assertAutomatic() {
    long shortest = EndpointQos.INFINITE;
    for (LocalEndpoint each : matching.own())
      if (isAutomatic(each.info())) shortest = Math.min(shortest, each.info().qos().lease());
    if (shortest == EndpointQos.INFINITE) return;
    say(AUTOMATIC);
    timer.in(Math.max(1, shortest / 3));
  }

  /** Vouches for all writers whose liveliness is that of the participant. */
  void assertManual() {
    say(MANUAL);
  }

  private void say(int kind) {
    ByteBuffer out = ByteBuffer.allocate(28).putInt(PLAIN_BIG_ENDIAN);
    environment.prefix.write(out);
    // No data: a sequence of bytes whose length is 0.
    out.putInt(kind).putInt(0).flip();
    writer.write(out, new InlineQos(false, new Guid(environment.prefix, kind), null));
  }

  @Override
  public boolean deliver(Sample sample) {
    try {
      ByteBuffer in = sample.payload().duplicate();
      in.getInt();
      GuidPrefix prefix = GuidPrefix.read(in);
      int kind = in.getInt();
      if (prefix.equals(sample.identity().writer().prefix()))
        routes.heard(prefix, kind == AUTOMATIC);
    } catch (BufferUnderflowException e) {
      return true;
    }
    return true;
  }

  @Override
  public void lost(Guid writer, long samples) {
    // The next one says the same.
  }
}
