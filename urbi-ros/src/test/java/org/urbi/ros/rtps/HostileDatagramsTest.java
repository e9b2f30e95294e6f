package org.urbi.ros.rtps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.ros.rtps.Neighbourhood.NO_DATA;
import static org.urbi.ros.rtps.Neighbourhood.TYPE;
import static org.urbi.ros.rtps.Neighbourhood.payload;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.urbi.ros.rtps.Neighbourhood.Receiving;
import org.urbi.ros.rtps.Neighbourhood.Sending;

/** Datagrams that nobody should send. */
class HostileDatagramsTest {
  private static final GuidPrefix SENDER = new GuidPrefix(7, 8, 9);
  private static final EndpointQos ALL = EndpointQos.reliable(EndpointQos.KEEP_ALL);
  private static final int WRITER = 0x103;
  private static final int READER = 0x104;

  /** One of each kind, as this implementation writes them. */
  private static List<byte[]> valid(GuidPrefix sender) {
    MessageBuilder message = new MessageBuilder(sender);
    SampleIdentity related = new SampleIdentity(new Guid(sender, READER), 5);
    Change small =
        new Change(3, 1_000_000_000, 0, payload(3, 30), new InlineQos(false, null, related));
    Change large = new Change(4, 1_000_000_000, 0, payload(4, 5000), InlineQos.NONE);
    SequenceSet missing = SequenceSet.from(2, 40);
    missing.add(2);
    missing.add(33);
    List<byte[]> all = new ArrayList<>();
    all.add(
        bytes(message.begin().data(0, WRITER, small).heartbeat(0, WRITER, 1, 3, 1, false, false)));
    all.add(bytes(message.begin().fragment(READER, WRITER, large, 2, 1024)));
    all.add(
        bytes(
            message
                .begin()
                .gap(READER, WRITER, 1, 4)
                .heartbeat(READER, WRITER, 4, 9, 2, true, true)));
    all.add(bytes(message.begin(SENDER).acknowledgement(READER, WRITER, missing, 1, false)));
    all.add(bytes(message.begin(SENDER).fragmentRequest(READER, WRITER, 4, missing, 1)));
    all.add(
        bytes(
            message
                .begin()
                .data(
                    EntityId.PARTICIPANT_READER,
                    EntityId.PARTICIPANT_WRITER,
                    described(sender, 7999))));
    Change endpoint =
        new Change(
            1,
            0,
            0,
            DiscoveryCodec.encode(endpoint(sender, 1)),
            new InlineQos(false, new Guid(sender, WRITER), null));
    all.add(bytes(message.begin().data(0, EntityId.PUBLICATIONS_WRITER, endpoint)));
    return all;
  }

  private static Change described(GuidPrefix prefix, int port) {
    List<InetSocketAddress> at = List.of(new InetSocketAddress("127.0.0.1", port));
    ParticipantInfo info =
        new ParticipantInfo(
            prefix, -1, "someone", new byte[] {1, 2}, at, at, 60_000_000_000L, ParticipantInfo.ALL);
    return new Change(1, 0, 0, DiscoveryCodec.encode(info), InlineQos.NONE);
  }

  private static EndpointInfo endpoint(GuidPrefix prefix, int number) {
    Guid guid = new Guid(prefix, EntityId.writer(number));
    return new EndpointInfo(
        guid, true, "rt/x", TYPE, ALL, new byte[] {3}, List.of(), false, List.of());
  }

  private static byte[] bytes(MessageBuilder message) {
    ByteBuffer out = message.finish();
    byte[] bytes = new byte[out.remaining()];
    out.get(bytes);
    return bytes;
  }

  private static boolean parses(byte[] bytes) {
    try {
      MessageParser.parse(ByteBuffer.wrap(bytes), (source, submessage) -> describe(submessage));
      return true;
    } catch (MalformedException e) {
      return false;
    }
  }

  /** Goes on with what is inside of a sample, as discovery does. */
  private static void describe(Submessage submessage) {
    if (!(submessage instanceof Submessage.Data data)) return;
    for (int way = 0; way < 4; way++) {
      try {
        switch (way) {
          case 0 -> DiscoveryCodec.decodeParticipant(data.payload());
          case 1 -> DiscoveryCodec.decodeEndpoint(data.payload(), true);
          case 2 -> DiscoveryCodec.decodeEndpoint(data.payload(), false);
          default -> DiscoveryCodec.decodeKey(data.payload());
        }
      } catch (MalformedException e) {
        assertTrue(!e.getMessage().isEmpty());
      }
    }
  }

  @Test
  void truncatedMessagesAreRefusedOrShort() {
    for (byte[] each : valid(SENDER)) {
      assertTrue(parses(each));
      for (int length = 0; length < each.length; length++)
        parses(java.util.Arrays.copyOf(each, length));
    }
  }

  @Test
  void whateverChangesInAMessageOnlyItsOwnExceptionComes() {
    Random random = new Random(42);
    List<byte[]> valid = valid(SENDER);
    int refused = 0;
    for (int i = 0; i < 300_000; i++)
      if (!parses(changed(valid.get(random.nextInt(valid.size())), random))) refused++;
    assertTrue(refused > 10_000, "refused: " + refused);
    for (int i = 0; i < 100_000; i++) {
      byte[] noise = new byte[random.nextInt(200)];
      random.nextBytes(noise);
      if (noise.length > 8) ByteBuffer.wrap(noise).putInt(0, MessageParser.MAGIC).put(4, (byte) 2);
      parses(noise);
    }
  }

  private static byte[] changed(byte[] original, Random random) {
    byte[] bytes = original.clone();
    for (int i = random.nextInt(4); i >= 0; i--) {
      int at = 20 + random.nextInt(bytes.length - 20);
      bytes[at] = (byte) (random.nextBoolean() ? random.nextInt(256) : random.nextInt(2) * 255);
    }
    return random.nextInt(4) == 0
        ? java.util.Arrays.copyOf(bytes, random.nextInt(bytes.length))
        : bytes;
  }

  @Test
  void aParticipantGoesOnUnderFire() throws Exception {
    Neighbourhood domain = new Neighbourhood();
    domain.expect(MalformedException.class);
    domain.expect(IOException.class);
    Participant target =
        domain.open(
            domain.options().withMemory(1 << 20, 4 << 20), Neighbourhood.prefix(), new Link(0, 0));
    Participant peer = domain.open();
    Receiving receiving = new Receiving(true);
    Sending sending = new Sending();
    target.reader("rt/x", TYPE, ALL, NO_DATA, receiving);
    Writer writer = peer.writer("rt/y", TYPE, ALL, NO_DATA, new Sending());
    target.writer("rt/y", TYPE, ALL, NO_DATA, new Sending());
    target.reader("rt/y", TYPE, ALL, NO_DATA, new Receiving(true));
    peer.writer("rt/x", TYPE, ALL, NO_DATA, sending);
    sending.awaitMatched();
    receiving.awaitMatched();
    // With the peer's name, so that it concerns what the target has.
    Random random = new Random(43);
    List<byte[]> valid = new ArrayList<>(valid(peer.info().prefix()));
    valid.addAll(valid(SENDER));
    try (Fire fire = new Fire(target)) {
      for (int i = 0; i < 30_000; i++)
        fire.send(changed(valid.get(random.nextInt(valid.size())), random));
    }
    // Neither thread has died, and whoever is honest is heard.
    Receiving afterwards = new Receiving(true);
    Sending honest = new Sending();
    Participant late = domain.open();
    target.reader("rt/z", TYPE, ALL, NO_DATA, afterwards);
    Writer lateWriter = late.writer("rt/z", TYPE, ALL, NO_DATA, honest);
    honest.awaitMatched();
    lateWriter.write(payload(1, 500_000));
    assertTrue(Neighbourhood.isPayload(afterwards.next().payload(), 1, 500_000));
    writer.close();
    domain.close();
  }

  /** A socket that shoots at a participant. */
  private static final class Fire implements AutoCloseable {
    private final java.nio.channels.DatagramChannel socket;
    private final InetSocketAddress target;

    Fire(Participant participant) throws IOException {
      socket = java.nio.channels.DatagramChannel.open(java.net.StandardProtocolFamily.INET);
      target = participant.info().discovery().getFirst();
    }

    void send(byte[] bytes) throws IOException {
      socket.send(ByteBuffer.wrap(bytes), target);
    }

    @Override
    public void close() throws IOException {
      socket.close();
    }
  }

  @Test
  void aFloodOfParticipantsIsBounded() throws Exception {
    Neighbourhood domain = new Neighbourhood();
    domain.expect(IllegalStateException.class);
    domain.expect(MalformedException.class);
    Participant target =
        domain.open(domain.options().withLimits(16, 8), Neighbourhood.prefix(), new Link(0, 0));
    try (Fire fire = new Fire(target)) {
      for (int i = 0; i < 500; i++) {
        GuidPrefix prefix = new GuidPrefix(1, 1, i);
        MessageBuilder message = new MessageBuilder(prefix);
        fire.send(
            bytes(message.begin().data(0, EntityId.PARTICIPANT_WRITER, described(prefix, 7999))));
        if (i % 20 == 0) Thread.sleep(1);
      }
      domain.awaitTold("trouble a participant is ignored: 16 others are known already");
      assertEquals(16, target.participants().size());
      // And each of them has so many endpoints at most.
      GuidPrefix known = target.participants().getFirst().prefix();
      MessageBuilder message = new MessageBuilder(known);
      for (int i = 1; i <= 100; i++) {
        Change change =
            new Change(i, 0, 0, DiscoveryCodec.encode(endpoint(known, i)), InlineQos.NONE);
        fire.send(
            bytes(
                message
                    .begin()
                    .data(0, EntityId.PUBLICATIONS_WRITER, change)
                    .heartbeat(0, EntityId.PUBLICATIONS_WRITER, 1, i, i, true, false)));
      }
      fire.send(
          bytes(
              message
                  .begin()
                  .heartbeat(
                      EntityId.PUBLICATIONS_READER,
                      EntityId.PUBLICATIONS_WRITER,
                      1,
                      100,
                      101,
                      true,
                      false)));
      domain.awaitTold("trouble a description of a writer or reader cannot be understood");
      assertEquals(8, target.endpoints().size());
    }
    domain.close();
  }

  // What fragments may take

  private static final Guid HOSTILE = new Guid(SENDER, WRITER);

  private static Environment environment(List<byte[]> sent) {
    ParticipantOptions options = ParticipantOptions.loopback(0).withMemory(1 << 20, 3 << 20);
    Reactor reactor = new Reactor("unused", (what, reason) -> {});
    return new Environment(
        new GuidPrefix(1, 2, 3),
        options,
        reactor,
        (datagram, to) -> {
          byte[] bytes = new byte[datagram.remaining()];
          datagram.get(bytes);
          sent.add(bytes);
        });
  }

  private static Submessage.DataFragments fragment(
      long sequence, int first, int fragmentSize, int size) {
    return new Submessage.DataFragments(
        READER,
        WRITER,
        sequence,
        InlineQos.NONE,
        first,
        1,
        fragmentSize,
        size,
        ByteBuffer.allocate(fragmentSize));
  }

  /** Has a reader with one writer received what a test wants; gives what memory is left then. */
  private static final class Victim implements SampleSink {
    final List<Sample> samples = new ArrayList<>();
    final List<byte[]> sent = new ArrayList<>();
    final Environment environment = environment(sent);
    final StatefulReader reader = new StatefulReader(environment, READER, ALL, this);
    final WriterProxy writer;
    long lost;

    Victim() {
      reader.match(HOSTILE, ALL, new InetSocketAddress("127.0.0.1", 7999));
      writer = java.util.Objects.requireNonNull(reader.of(HOSTILE));
    }

    @Override
    public boolean deliver(Sample sample) {
      return samples.add(sample);
    }

    @Override
    public void lost(Guid from, long count) {
      lost += count;
    }
  }

  @Test
  void fragmentsTakeNoMoreMemoryThanAllowed() {
    Victim victim = new Victim();
    victim.writer.received(new Submessage.Heartbeat(READER, WRITER, 1, 0, 1, false, false));
    victim.writer.received(fragment(1, 1, 1000, Integer.MAX_VALUE), 0);
    assertEquals(3 << 20, victim.environment.halfReceived.left(), "larger than samples may be");
    for (int i = 1; i < 100; i++) victim.writer.received(fragment(i, 1, 1000, 1 << 20), 0);
    assertEquals(0, victim.environment.halfReceived.left());
    for (int i = 0; i < 10_000; i++)
      victim.writer.received(
          new Submessage.Data(
              READER, WRITER, 2 + i, InlineQos.NONE, ByteBuffer.allocate(1000), false),
          0);
    assertTrue(victim.environment.halfReceived.left() >= 0);
    victim.reader.close();
    assertEquals(3 << 20, victim.environment.halfReceived.left(), "all is given back");
  }

  @Test
  void fragmentsThatContradictEachOtherAreNotMixed() {
    Victim victim = new Victim();
    victim.writer.received(new Submessage.Heartbeat(READER, WRITER, 1, 0, 1, false, false));
    victim.writer.received(fragment(1, 1, 1000, 2500), 0);
    victim.writer.received(fragment(1, 2, 2000, 2500), 0);
    victim.writer.received(fragment(1, 1, 1000, 1000), 0);
    assertEquals(0, victim.samples.size());
    victim.writer.received(fragment(1, 2, 1000, 2500), 0);
    Submessage.DataFragments last =
        new Submessage.DataFragments(
            READER, WRITER, 1, InlineQos.NONE, 3, 1, 1000, 2500, ByteBuffer.allocate(500));
    victim.writer.received(last, 0);
    assertEquals(2500, victim.samples.getFirst().payload().remaining());
    assertEquals(3 << 20, victim.environment.halfReceived.left());
  }

  @Test
  void sequenceNumbersFarAwayCostNothing() {
    Victim victim = new Victim();
    victim.writer.received(new Submessage.Heartbeat(READER, WRITER, 1, 0, 1, false, false));
    long far = 1L << 59;
    victim.writer.received(
        new Submessage.Data(READER, WRITER, far, InlineQos.NONE, ByteBuffer.allocate(10), false),
        0);
    victim.writer.received(new Submessage.Gap(READER, WRITER, 1L << 40, SequenceSet.empty(far)));
    victim.writer.received(new Submessage.Heartbeat(READER, WRITER, 1, far, 2, false, false));
    assertEquals(0, victim.lost);
    victim.writer.received(new Submessage.Heartbeat(READER, WRITER, far, far, 3, false, false));
    assertEquals(far - 1, victim.lost);
    victim.writer.received(
        new Submessage.Data(READER, WRITER, far, InlineQos.NONE, ByteBuffer.allocate(10), false),
        0);
    assertEquals(1, victim.samples.size());
  }

  @Test
  void numbersOutOfRangeAreRefused() {
    byte[] heartbeat =
        bytes(new MessageBuilder(SENDER).begin().heartbeat(0, WRITER, 1, 3, 1, false, false));
    ByteBuffer bytes = ByteBuffer.wrap(heartbeat).order(ByteOrder.LITTLE_ENDIAN);
    assertTrue(parses(heartbeat));
    bytes.putInt(40, 1 << 30);
    assertTrue(!parses(heartbeat), "sequence number beyond 2^60");
    bytes.putInt(40, -1);
    assertTrue(!parses(heartbeat), "negative sequence number");
    SequenceSet some = SequenceSet.from(1, 32);
    byte[] answer =
        bytes(new MessageBuilder(SENDER).begin().acknowledgement(READER, WRITER, some, 1, false));
    ByteBuffer.wrap(answer).order(ByteOrder.LITTLE_ENDIAN).putInt(40, 257);
    assertTrue(!parses(answer), "set of 257");
    ByteBuffer.wrap(answer).order(ByteOrder.LITTLE_ENDIAN).putInt(40, -1);
    assertTrue(!parses(answer), "set of 4 G");
  }
}
