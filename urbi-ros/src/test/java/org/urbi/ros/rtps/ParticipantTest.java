package org.urbi.ros.rtps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.ros.rtps.Neighbourhood.NO_DATA;
import static org.urbi.ros.rtps.Neighbourhood.TYPE;
import static org.urbi.ros.rtps.Neighbourhood.isPayload;
import static org.urbi.ros.rtps.Neighbourhood.millis;
import static org.urbi.ros.rtps.Neighbourhood.payload;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.ros.Awaited;
import org.urbi.ros.rtps.EndpointQos.Liveliness;
import org.urbi.ros.rtps.Neighbourhood.Receiving;
import org.urbi.ros.rtps.Neighbourhood.Sending;

/** Participants with each other, over networks good and bad. */
class ParticipantTest {
  private static final EndpointQos ALL = EndpointQos.reliable(EndpointQos.KEEP_ALL);
  private static final long LONG = TimeUnit.MINUTES.toNanos(1);

  @ParameterizedTest
  @CsvSource({
    "0, 5000, 1000",
    "7, 2000, 1000",
    "2, 200, 1000",
    "0, 20, 1048576",
    "7, 10, 1048576",
    "3, 5, 300001"
  })
  void allArrivesInOrderWhateverIsLost(int losesOneOf, int count, int size) throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Receiving receiving = new Receiving(true);
      Sending sending = new Sending();
      domain.open(new Link(losesOneOf, 1)).reader("rt/x", TYPE, ALL, NO_DATA, receiving);
      Writer writer =
          domain.open(new Link(losesOneOf, 2)).writer("rt/x", TYPE, ALL, NO_DATA, sending);
      sending.awaitMatched();
      for (int i = 0; i < count; i++) {
        assertTrue(writer.awaitRoom(LONG));
        assertEquals(i + 1, writer.write(payload(i, size)));
      }
      for (int i = 0; i < count; i++) {
        Sample sample = receiving.next();
        assertEquals(new SampleIdentity(writer.guid(), i + 1), sample.identity());
        assertTrue(isPayload(sample.payload(), i, size), "sample " + i);
      }
      assertTrue(writer.awaitAcknowledged(LONG));
    }
  }

  @Test
  void burstsOfManyArriveOverABadNetworkAlsoWithThoseWhoJoinInTheirMiddle() throws Exception {
    EndpointQos qos = ALL.asTransientLocal();
    int rounds = 60;
    try (Neighbourhood domain = new Neighbourhood()) {
      Participant sender = domain.open(new Link(5, 1));
      Participant receiver = domain.open(new Link(5, 2));
      List<Writer> writers = new ArrayList<>();
      List<Receiving> all = new ArrayList<>();
      for (int i = 0; i < 10; i++) {
        Receiving receiving = new Receiving(true);
        receiver.reader("rt/" + i, TYPE, qos, NO_DATA, receiving);
        all.add(receiving);
        Sending sending = new Sending();
        writers.add(sender.writer("rt/" + i, TYPE, qos, NO_DATA, sending));
        sending.awaitMatched();
      }
      for (int round = 0; round < rounds; round++) {
        for (Writer each : writers) assertTrue(each.write(payload(round, 500)) > 0);
        if (round != rounds / 2) continue;
        Participant late = domain.open(new Link(5, 3));
        for (int i = 0; i < 10; i++) {
          Receiving receiving = new Receiving(true);
          (i % 2 == 0 ? late : receiver).reader("rt/" + i, TYPE, qos, NO_DATA, receiving);
          all.add(receiving);
        }
      }
      for (Receiving each : all)
        for (int i = 0; i < rounds; i++) assertTrue(isPayload(each.next().payload(), i, 500));
      for (Writer each : writers) assertTrue(each.awaitAcknowledged(LONG));
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void whatWasWrittenBeforeTheEndArrives(boolean participantEnds) throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Receiving receiving = new Receiving(true);
      Sending sending = new Sending();
      domain.open(new Link(4, 1)).reader("rt/x", TYPE, ALL, NO_DATA, receiving);
      ParticipantOptions patient = domain.options().withLinger(Duration.ofMinutes(1));
      Participant sender = domain.open(patient, Neighbourhood.prefix(), new Link(4, 2));
      Writer writer = sender.writer("rt/x", TYPE, ALL, NO_DATA, sending);
      sending.awaitMatched();
      for (int i = 0; i < 200; i++) assertEquals(i + 1, writer.write(payload(i, 500)));
      writer.close();
      assertEquals(0, writer.write(payload(0, 500)));
      if (participantEnds) sender.close();
      for (int i = 0; i < 200; i++) assertTrue(isPayload(receiving.next().payload(), i, 500));
    }
  }

  @Test
  void whoDoesNotAnswerKeepsNobodyFromEnding() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Link link = new Link(0, 1);
      Sending sending = new Sending();
      domain.open(link).reader("rt/x", TYPE, ALL, NO_DATA, new Receiving(true));
      Participant sender = domain.open();
      Writer writer = sender.writer("rt/x", TYPE, ALL, NO_DATA, sending);
      sending.awaitMatched();
      link.cut(true);
      writer.write(payload(1, 40));
      writer.close();
      domain.awaitTold("lost rt/x");
      Writer other = sender.writer("rt/x", TYPE, EndpointQos.bestEffort(1), NO_DATA, sending);
      other.write(payload(1, 40));
      sender.close();
      domain.awaitTold("lost " + sender.info().prefix());
    }
  }

  /** A listener may close the participant: others are told all the same, not by its silence. */
  @Test
  void whatClosesItselfSaysGoodBye() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Participant[] brief = new Participant[1];
      ReaderListener closing =
          new ReaderListener() {
            @Override
            public void available(Reader reader) {
              brief[0].close();
            }
          };
      brief[0] =
          domain.open(
              domain.options().withLease(Duration.ofHours(1)),
              Neighbourhood.prefix(),
              new Link(0, 0));
      brief[0].reader("rt/x", TYPE, ALL, NO_DATA, closing);
      Sending sending = new Sending();
      Writer writer = domain.open().writer("rt/x", TYPE, ALL, NO_DATA, sending);
      sending.awaitMatched();
      writer.write(payload(1, 40));
      domain.awaitTold("lost " + brief[0].info().prefix());
    }
  }

  @Test
  void atBestEffortWhatArrivesIsInOrderAndNothingIsRepeated() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Receiving receiving = new Receiving(true);
      Link link = new Link(0, 3);
      EndpointQos qos = EndpointQos.bestEffort(10);
      Participant sender = domain.open(link);
      Reader reader = domain.open().reader("rt/x", TYPE, qos, NO_DATA, receiving);
      Sending sending = new Sending();
      Writer writer = sender.writer("rt/x", TYPE, EndpointQos.reliable(10), NO_DATA, sending);
      sending.awaitMatched();
      receiving.awaitMatched();
      writer.write(payload(1, 100));
      assertEquals(1, receiving.next().identity().sequence());
      link.cut(true);
      writer.write(payload(2, 100));
      // So soon after the first one, it may wait for more.
      Awaited.until("a loss", () -> link.lost() > 0);
      link.cut(false);
      writer.write(payload(3, 200_000));
      assertTrue(isPayload(receiving.next().payload(), 3, 200_000));
      assertEquals(0, reader.overwritten());
    }
  }

  @Test
  void whoComesLateGetsWhatIsKeptIfItWantsIt() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Writer writer =
          domain
              .open()
              .writer(
                  "rt/x", TYPE, EndpointQos.reliable(3).asTransientLocal(), NO_DATA, new Sending());
      for (int i = 1; i <= 10; i++) writer.write(payload(i, i == 9 ? 100_000 : 50));
      Receiving late = new Receiving(true);
      Receiving effort = new Receiving(true);
      Receiving fresh = new Receiving(true);
      Participant other = domain.open();
      other.reader("rt/x", TYPE, EndpointQos.reliable(10).asTransientLocal(), NO_DATA, late);
      other.reader("rt/x", TYPE, EndpointQos.bestEffort(10).asTransientLocal(), NO_DATA, effort);
      other.reader("rt/x", TYPE, EndpointQos.reliable(10), NO_DATA, fresh);
      for (int i = 8; i <= 10; i++) assertEquals(i, late.next().identity().sequence());
      Awaited.until("three readers", () -> writer.matched().size() >= 3);
      writer.write(payload(11, 50));
      assertEquals(11, fresh.next().identity().sequence());
      assertEquals(11, late.next().identity().sequence());
      assertTrue(effort.next().identity().sequence() >= 8);
    }
  }

  @Test
  void readersOfTheSameParticipantHearItsWriters() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Participant alone = domain.open();
      Receiving one = new Receiving(true);
      Receiving two = new Receiving(true);
      Writer writer = alone.writer("rt/x", TYPE, ALL, NO_DATA, new Sending());
      alone.reader("rt/x", TYPE, ALL, NO_DATA, one);
      alone.reader("rt/x", TYPE, EndpointQos.bestEffort(1), NO_DATA, two);
      alone.reader("rt/x", "another", ALL, NO_DATA, new Receiving(true));
      assertEquals(2, writer.matched().size());
      writer.write(payload(1, 70_000));
      assertTrue(isPayload(one.next().payload(), 1, 70_000));
      assertTrue(isPayload(two.next().payload(), 1, 70_000));
    }
  }

  @Test
  void aWriterThatKeepsAllIsToldToWait() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Receiving receiving = new Receiving(false);
      Sending sending = new Sending();
      Reader reader = domain.open().reader("rt/x", TYPE, ALL, NO_DATA, receiving);
      Writer writer = domain.open().writer("rt/x", TYPE, ALL, NO_DATA, sending);
      sending.awaitMatched();
      int written = 0;
      while (written < 3 * History.ALL && writer.write(payload(written, 40)) > 0) {
        written++;
        if (!writer.hasRoom()) writer.awaitRoom(TimeUnit.MILLISECONDS.toNanos(500));
      }
      // What the reader keeps, what came too early for that, and what the writer keeps.
      assertTrue(written >= History.ALL && written < 3 * History.ALL, "written: " + written);
      int taken = 0;
      while (taken < written) {
        Sample sample = reader.take();
        if (sample == null) Thread.sleep(1);
        else assertTrue(isPayload(sample.payload(), taken++, 40));
      }
      Awaited.zero(sending.room, "no room");
      assertTrue(writer.awaitAcknowledged(LONG));
      assertEquals(0, reader.overwritten());
    }
  }

  @Test
  void aReaderKeepsTheNewest() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Sending sending = new Sending();
      Reader reader =
          domain
              .open()
              .reader("rt/x", TYPE, EndpointQos.reliable(5), NO_DATA, new Receiving(false));
      Writer writer = domain.open().writer("rt/x", TYPE, ALL, NO_DATA, sending);
      sending.awaitMatched();
      for (int i = 1; i <= 100; i++) writer.write(payload(i, 40));
      assertTrue(writer.awaitAcknowledged(LONG));
      for (int i = 96; i <= 100; i++) assertTrue(isPayload(reader.take().payload(), i, 40));
      assertEquals(null, reader.take());
      assertEquals(95, reader.overwritten());
    }
  }

  @Test
  void bothAreToldWhichPolicyHinders() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Participant one = domain.open();
      Participant two = domain.open();
      EndpointQos offered = EndpointQos.reliable(1);
      EndpointQos slow = offered.withDeadline(2_000_000_000L);
      hinders(one, two, "reliability", EndpointQos.bestEffort(1), offered);
      hinders(one, two, "durability", offered, offered.asTransientLocal());
      hinders(one, two, "deadline", slow, offered.withDeadline(1_000_000_000L));
      hinders(one, two, "deadline", offered, slow);
      hinders(
          one,
          two,
          "liveliness",
          offered,
          offered.withLiveliness(Liveliness.MANUAL_BY_TOPIC, EndpointQos.INFINITE));
      hinders(
          one,
          two,
          "liveliness",
          offered,
          offered.withLiveliness(Liveliness.AUTOMATIC, 1_000_000_000L));
    }
  }

  private int topics;

  private void hinders(
      Participant one, Participant two, String policy, EndpointQos offered, EndpointQos requested)
      throws Exception {
    String topic = "rt/" + ++topics;
    Sending sending = new Sending();
    Receiving receiving = new Receiving(true);
    one.writer(topic, TYPE, offered, NO_DATA, sending);
    two.reader(topic, TYPE, requested, NO_DATA, receiving);
    assertEquals(policy, Awaited.next(sending.hindered));
    assertEquals(policy, Awaited.next(receiving.events));
  }

  @Test
  void whoFallsSilentIsForgotten() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Link link = new Link(0, 0);
      Participant mortal =
          domain.open(domain.options().withLease(millis(600)), Neighbourhood.prefix(), link);
      Receiving receiving = new Receiving(true);
      Sending sending = new Sending();
      Participant survivor = domain.open();
      Writer writer = survivor.writer("rt/x", TYPE, ALL, NO_DATA, sending);
      mortal.reader("rt/x", TYPE, ALL, NO_DATA, receiving);
      mortal.writer("rt/y", TYPE, ALL, NO_DATA, new Sending());
      sending.awaitMatched();
      domain.awaitTold("found rt/y");
      link.cut(true);
      writer.write(payload(1, 40));
      assertFalse(writer.awaitAcknowledged(1));
      domain.awaitTold("lost rt/x");
      domain.awaitTold("lost rt/y");
      domain.awaitTold("lost " + mortal.info().prefix());
      Awaited.zero(sending.unmatched, "still matched");
      assertTrue(writer.awaitAcknowledged(LONG), "nobody is waited for who is gone");
      assertEquals(0, survivor.participants().size());
      link.cut(false);
      Awaited.until("both endpoints", () -> survivor.endpoints().size() >= 2);
    }
  }

  @Test
  void whoGoesSaysGoodBye() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Receiving receiving = new Receiving(true);
      domain.open().reader("rt/x", TYPE, ALL, NO_DATA, receiving);
      Participant guest = domain.open();
      Writer writer = guest.writer("rt/x", TYPE, ALL, NO_DATA, new Sending());
      Writer second = guest.writer("rt/x", TYPE, ALL, NO_DATA, new Sending());
      receiving.await("matched");
      receiving.await("matched");
      writer.close();
      receiving.await("unmatched");
      assertEquals(0, writer.write(payload(1, 40)));
      guest.close();
      receiving.await("unmatched");
      domain.awaitTold("lost " + guest.info().prefix());
      assertThrows(
          IllegalStateException.class,
          () -> guest.writer("rt/x", TYPE, ALL, NO_DATA, new Sending()));
      assertEquals(0, second.write(payload(1, 40)));
    }
  }

  /** Whether a reader of the user's says there what it has; not one of discovery. */
  private static boolean acknowledges(ByteBuffer datagram) {
    boolean[] found = {false};
    try {
      MessageParser.parse(
          datagram.duplicate(),
          (source, submessage) ->
              found[0] |=
                  submessage instanceof Submessage.Acknowledgement(var reader, _, _, _, _)
                      && (reader & 0xC0) == 0);
    } catch (MalformedException e) {
      throw new AssertionError(e);
    }
    return found[0];
  }

  /** It tells the reader where it begins, again and again: that is not a beginning anew. */
  @Test
  void aWriterThatHearsNothingOfItsReader() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Receiving receiving = new Receiving(true);
      domain
          .open(network ->
              (datagram, to) -> {
                if (!acknowledges(datagram)) network.send(datagram, to);
              })
          .reader("rt/x", TYPE, ALL, NO_DATA, receiving);
      Sending sending = new Sending();
      Writer writer = domain.open().writer("rt/x", TYPE, ALL, NO_DATA, sending);
      sending.awaitMatched();
      receiving.awaitMatched();
      for (int i = 0; i < 3; i++) {
        writer.write(payload(i, 40));
        assertTrue(isPayload(receiving.next().payload(), i, 40));
      }
      assertEquals(null, receiving.samples.poll(700, TimeUnit.MILLISECONDS));
      writer.write(payload(3, 40));
      assertTrue(isPayload(receiving.next().payload(), 3, 40));
    }
  }

  @Test
  void whoComesBackUnderTheSameNameIsAnotherOne() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      GuidPrefix name = Neighbourhood.prefix();
      Link link = new Link(0, 0);
      Participant first = domain.open(domain.options(), name, link);
      Receiving receiving = new Receiving(true);
      domain.open().reader("rt/x", TYPE, ALL, NO_DATA, receiving);
      Sending sending = new Sending();
      Writer writer = first.writer("rt/x", TYPE, ALL, NO_DATA, sending);
      sending.awaitMatched();
      for (int i = 0; i < 50; i++) writer.write(payload(i, 40));
      for (int i = 0; i < 50; i++) receiving.next();
      // It dies without a word, and another process has its ports and its name at once.
      link.cut(true);
      first.close();
      Participant second = domain.open(domain.options(), name, new Link(0, 0));
      Sending again = new Sending();
      Writer reborn = second.writer("rt/x", TYPE, ALL, NO_DATA, again);
      again.awaitMatched();
      for (int i = 100; i < 110; i++) reborn.write(payload(i, 40));
      for (int i = 100; i < 110; i++) assertTrue(isPayload(receiving.next().payload(), i, 40));
    }
  }

  @Test
  void participantsVouchForTheirWriters() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Link link = new Link(0, 0);
      EndpointQos qos = EndpointQos.reliable(1).withLiveliness(Liveliness.AUTOMATIC, 500_000_000L);
      Receiving receiving = new Receiving(true);
      domain.open().reader("rt/x", TYPE, qos, NO_DATA, receiving);
      Sending sending = new Sending();
      Participant vouching = domain.open(link);
      vouching.writer("rt/x", TYPE, qos, NO_DATA, sending);
      sending.awaitMatched();
      receiving.await("matched");
      assertEquals(
          null,
          receiving.events.poll(1500, TimeUnit.MILLISECONDS),
          "it is alive without a word of its own");
      link.cut(true);
      receiving.await("not alive");
      link.cut(false);
      receiving.await("alive");
    }
  }

  @Test
  void manualLivelinessNeedsWords() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Participant one = domain.open();
      Participant two = domain.open();
      EndpointQos mine =
          EndpointQos.reliable(1).withLiveliness(Liveliness.MANUAL_BY_TOPIC, 300_000_000L);
      EndpointQos ours =
          EndpointQos.reliable(1).withLiveliness(Liveliness.MANUAL_BY_PARTICIPANT, 300_000_000L);
      Receiving first = new Receiving(true);
      Receiving second = new Receiving(true);
      two.reader("rt/x", TYPE, mine, NO_DATA, first);
      two.reader("rt/y", TYPE, ours, NO_DATA, second);
      Writer writer = one.writer("rt/x", TYPE, mine, NO_DATA, new Sending());
      one.writer("rt/y", TYPE, ours, NO_DATA, new Sending());
      first.await("not alive");
      second.await("not alive");
      writer.assertLiveliness();
      first.await("alive");
      one.assertLiveliness();
      second.await("alive");
      first.await("not alive");
      writer.write(payload(1, 40));
      first.await("alive");
    }
  }

  @Test
  void aMissedDeadlineIsTold() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      EndpointQos qos = EndpointQos.reliable(1).withDeadline(200_000_000L);
      Receiving receiving = new Receiving(true);
      domain.open().reader("rt/x", TYPE, qos, NO_DATA, receiving);
      domain.open().writer("rt/x", TYPE, qos, NO_DATA, new Sending());
      receiving.await("matched");
      receiving.await("deadline");
      receiving.await("deadline");
    }
  }

  @Test
  void anAnswerNamesWhatItAnswers() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Participant one = domain.open();
      Receiving receiving = new Receiving(true);
      domain.open().reader("rr/x", TYPE, ALL, NO_DATA, receiving);
      Sending sending = new Sending();
      Writer writer = one.writer("rr/x", TYPE, ALL, NO_DATA, sending);
      sending.awaitMatched();
      SampleIdentity asked = new SampleIdentity(new Guid(new GuidPrefix(1, 2, 3), 0x104), 42);
      writer.write(payload(1, 40), asked);
      writer.write(payload(2, 100_000), asked);
      assertEquals(asked, receiving.next().related());
      Sample large = receiving.next();
      assertEquals(asked, large.related());
      long ago = System.currentTimeMillis() - TimeUnit.NANOSECONDS.toMillis(large.sourceTime());
      assertTrue(ago >= 0 && ago < TimeUnit.MINUTES.toMillis(10), "written " + ago + " ms ago");
    }
  }

  @Test
  void whatIsTooOldIsNotSent() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      EndpointQos qos = EndpointQos.reliable(10).asTransientLocal();
      Writer writer =
          domain.open().writer("rt/x", TYPE, qos.withLifespan(1_000_000), NO_DATA, new Sending());
      writer.write(payload(1, 40));
      Thread.sleep(5);
      writer.write(payload(2, 40));
      Receiving receiving = new Receiving(true);
      domain.open().reader("rt/x", TYPE, qos, NO_DATA, receiving);
      receiving.awaitMatched();
      writer.write(payload(3, 40));
      long first = receiving.next().identity().sequence();
      assertTrue(first >= 2, "sample " + first);
    }
  }

  @Test
  void aSampleMayBeTooLarge() throws Exception {
    try (Neighbourhood domain = new Neighbourhood()) {
      Participant small =
          domain.open(
              domain.options().withMemory(1000, 10_000), Neighbourhood.prefix(), new Link(0, 0));
      Writer writer = small.writer("rt/x", TYPE, ALL, NO_DATA, new Sending());
      var refused =
          assertThrows(IllegalArgumentException.class, () -> writer.write(payload(1, 1001)));
      assertEquals("sample of 1001 bytes, at most are allowed 1000", refused.getMessage());
    }
  }
}
