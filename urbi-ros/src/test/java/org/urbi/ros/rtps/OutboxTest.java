package org.urbi.ros.rtps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.ros.rtps.Neighbourhood.payload;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.urbi.ros.rtps.Submessage.Acknowledgement;
import org.urbi.ros.rtps.Submessage.Data;
import org.urbi.ros.rtps.Submessage.Heartbeat;

/** What goes together in a datagram. */
class OutboxTest {
  private static final int WRITER = 0x103;
  private static final EndpointQos ALL = EndpointQos.reliable(EndpointQos.KEEP_ALL);
  private static final InetSocketAddress HERE = new InetSocketAddress("127.0.0.1", 7999);
  private static final InetSocketAddress THERE = new InetSocketAddress("127.0.0.1", 7998);
  private static final Guid READER = new Guid(new GuidPrefix(9, 9, 9), 0x104);

  private final List<List<Submessage>> sent = new ArrayList<>();
  private final List<Integer> sizes = new ArrayList<>();
  private final Environment environment =
      new Environment(
          new GuidPrefix(1, 2, 3),
          ParticipantOptions.loopback(0),
          new Reactor("unused", (what, reason) -> {}),
          this::received);

  private void received(ByteBuffer datagram, InetSocketAddress to) {
    sizes.add(datagram.remaining());
    List<Submessage> submessages = new ArrayList<>();
    sent.add(submessages);
    ByteBuffer copy = ByteBuffer.allocate(datagram.remaining()).put(datagram).flip();
    try {
      MessageParser.parse(copy, (source, submessage) -> submessages.add(submessage));
    } catch (MalformedException e) {
      throw new AssertionError(e);
    }
  }

  private StatefulWriter writer(int entity, InetSocketAddress... addresses) {
    StatefulWriter writer = new StatefulWriter(environment, entity, ALL, () -> {});
    for (InetSocketAddress each : addresses)
      writer.match(
          new Guid(new GuidPrefix(9, 9, each.getPort() == HERE.getPort() ? 9 : 8), 0x104),
          ALL,
          each);
    environment.outbox.flush();
    sent.clear();
    sizes.clear();
    return writer;
  }

  private static void write(StatefulWriter writer, int count, int size) {
    for (int i = 0; i < count; i++) writer.write(payload(i, size), InlineQos.NONE);
  }

  private List<Data> samples() {
    return sent.stream()
        .flatMap(List::stream)
        .filter(Data.class::isInstance)
        .map(Data.class::cast)
        .toList();
  }

  @Test
  void whatIsWrittenAtOnceSharesADatagram() {
    StatefulWriter writer = writer(WRITER, HERE);
    write(writer, 40, 1000);
    assertEquals(0, sent.size(), "nothing is sent before the lock is left");
    environment.outbox.flush();
    assertEquals(1, sent.size());
    assertEquals(
        LongStream.rangeClosed(1, 40).boxed().toList(),
        samples().stream().map(Data::sequence).toList());
    Submessage last = sent.getFirst().getLast();
    assertTrue(last instanceof Heartbeat h && h.last() == 40 && !h.answerIsOptional(), "" + last);
    assertEquals(41, sent.getFirst().size(), "one heartbeat is enough");
  }

  @Test
  void theWindowHoldsForDatagramsWithManySamples() {
    StatefulWriter writer = writer(WRITER, HERE);
    write(writer, 1000, 1000);
    environment.outbox.flush();
    int first = samples().size();
    assertTrue(first > 40 && first < 200, first + " before anything was acknowledged");
    for (int size : sizes) assertTrue(size <= 60_256, size + " bytes");
    writer.received(READER, new Acknowledgement(0x104, WRITER, SequenceSet.empty(11), 1, true));
    environment.outbox.flush();
    assertTrue(samples().size() >= first + 10, samples().size() + " after ten");
    assertTrue(samples().size() <= first + 12, samples().size() + " after ten");
  }

  @Test
  void aFullDatagramLeavesAtOnce() {
    StatefulWriter writer = writer(WRITER, HERE);
    write(writer, 1, 59_000);
    write(writer, 1, 59_000);
    assertEquals(1, sent.size());
    write(writer, 1, 100);
    environment.outbox.flush();
    assertEquals(2, sent.size());
    assertEquals(3, samples().size());
  }

  @Test
  void whatManyWritersSayOfThemselvesFits() {
    List<StatefulWriter> writers = new ArrayList<>();
    for (int i = 0; i < 700; i++) writers.add(writer(EntityId.writer(i + 1), HERE));
    writers.forEach(each -> write(each, 1, 40));
    environment.outbox.flush();
    for (int size : sizes) assertTrue(size <= 60_256, size + " bytes");
    assertTrue(sent.size() < 10, sent.size() + " datagrams");
    assertEquals(700, samples().size());
    assertEquals(1400, sent.stream().mapToInt(List::size).sum());
  }

  @Test
  void anAnswerLeavesWithTheSampleThatFollowsIt() {
    StatefulWriter writer = writer(WRITER, HERE);
    environment
        .outbox
        .to(HERE, READER.prefix(), MessageBuilder.SET_SIZE)
        .acknowledgement(0x107, 0x102, SequenceSet.empty(5), 1, true);
    write(writer, 1, 40);
    environment.outbox.leave();
    assertEquals(1, sent.size());
    assertTrue(sent.getFirst().getFirst() instanceof Acknowledgement);
    assertEquals(1, samples().size());
  }

  @Test
  void anAnswerIsNotDelayedBySamplesForOthers() {
    StatefulWriter writer = writer(WRITER, THERE);
    write(writer, 1, 40);
    environment
        .outbox
        .to(HERE, READER.prefix(), MessageBuilder.SET_SIZE)
        .acknowledgement(0x107, 0x102, SequenceSet.empty(5), 1, true);
    environment.outbox.leave();
    assertEquals(2, sent.size());
    assertTrue(sent.getLast().getLast() instanceof Acknowledgement);
  }

  @Test
  void whatIsForOthersIsNotDelayedByIt() {
    StatefulWriter here = writer(WRITER, HERE);
    StatefulWriter there = writer(EntityId.writer(2), THERE);
    StatefulWriter both = writer(EntityId.writer(3), HERE, THERE);
    write(here, 1, 40);
    write(there, 1, 40);
    write(both, 1, 40);
    write(here, 1, 40);
    environment.outbox.flush();
    assertEquals(5, sent.size());
    assertEquals(List.of(1L, 1L, 1L, 1L, 2L), samples().stream().map(Data::sequence).toList());
  }

  @Test
  void aWriterThatIsClosedHasSaidWhatItHad() {
    StatefulWriter writer = writer(WRITER, HERE);
    write(writer, 3, 40);
    writer.close();
    environment.outbox.flush();
    assertEquals(3, samples().size());
  }

  /** Whoever is told of samples that are still to come asks for them in vain, and again. */
  private void nothingIsPromisedBeforeItIsSent() {
    long newest = 0;
    for (List<Submessage> datagram : sent)
      for (Submessage each : datagram) {
        if (each instanceof Data data) newest = Math.max(newest, data.sequence());
        if (each instanceof Heartbeat told) assertTrue(told.last() <= newest, sent::toString);
      }
  }

  @Test
  void whatIsMissingGoesWithWhatHasNotLeftYet() {
    StatefulWriter writer = writer(WRITER, HERE);
    write(writer, 3, 40);
    environment.outbox.flush();
    write(writer, 2, 40);
    // The second is lost; and one that cannot know of it wants the fourth, which has not left.
    SequenceSet missing = SequenceSet.from(2, 3);
    missing.add(2);
    missing.add(4);
    writer.received(READER, new Acknowledgement(0x104, WRITER, missing, 1, true));
    writer.assertLiveliness();
    write(writer, 1, 40);
    environment.outbox.flush();
    assertEquals(
        List.of(1L, 2L, 3L, 4L, 5L, 2L, 4L, 6L), samples().stream().map(Data::sequence).toList());
    nothingIsPromisedBeforeItIsSent();
  }

  @Test
  void whoJoinsWhileSamplesWaitIsNotToldToWaitForThem() {
    StatefulWriter writer = writer(WRITER, HERE);
    write(writer, 2, 40);
    writer.match(new Guid(new GuidPrefix(9, 9, 8), 0x104), ALL, THERE);
    write(writer, 1, 40);
    environment.outbox.flush();
    assertEquals(
        List.of(1L, 2L, 3L, 3L),
        samples().stream().map(Data::sequence).toList(),
        "the third to both");
    List<Submessage.Gap> gaps =
        sent.stream()
            .flatMap(List::stream)
            .filter(Submessage.Gap.class::isInstance)
            .map(Submessage.Gap.class::cast)
            .toList();
    assertEquals(1, gaps.size());
    assertEquals(3, gaps.getFirst().set().base(), "it begins with the third");
    nothingIsPromisedBeforeItIsSent();
  }

  @Test
  void whoLeavesWhileSamplesWaitIsNotWaitedFor() {
    StatefulWriter writer = writer(WRITER, HERE);
    write(writer, 2, 40);
    writer.unmatch(READER);
    write(writer, 1, 40);
    environment.outbox.flush();
    assertEquals(2, samples().size());
    assertTrue(writer.isAcknowledged());
  }
}
