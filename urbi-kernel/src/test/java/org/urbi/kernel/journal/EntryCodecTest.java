package org.urbi.kernel.journal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.net.InetSocketAddress;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.message.Data;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;
import urbi.UValue;

/** What is written is read again. */
class EntryCodecTest {
  private static Object copy(Object entry) {
    DataWriter out = new DataWriter();
    EntryCodec.write(out, entry);
    DataReader in = new DataReader(out.take());
    Object copy = EntryCodec.read(in);
    assertEquals(false, in.hasMore());
    return copy;
  }

  private static Object sample(Class<?> type) {
    Map<Class<?>, Object> samples =
        Map.of(
            int.class,
            -70_000,
            long.class,
            Long.MIN_VALUE,
            boolean.class,
            true,
            double.class,
            0.1,
            String.class,
            "na\u00efve \u20ac",
            byte[].class,
            new byte[] {0, -1, 7},
            List.class,
            List.of("a", "b"),
            UValue[].class,
            new UValue[] {new UValue(1.5), new UValue("text")},
            Message.class,
            new Message.InputEnded(3));
    return type.isEnum()
        ? type.getEnumConstants()[1]
        : type == Data.class ? new Data(List.of(1.5, new Data.Handle(7))) : sample(type, samples);
  }

  private static Object sample(Class<?> type, Map<Class<?>, Object> samples) {
    return type == Outcome.class
        ? Outcome.value(12L)
        : type == InetSocketAddress.class
            ? new InetSocketAddress("127.0.0.1", 54000)
            : type == UValue.class
                ? new UValue("text")
                : Objects.requireNonNull(samples.get(type), type::toString);
  }

  private static Stream<Class<?>> records(Class<?> type) {
    return type.isRecord()
        ? Stream.of(type)
        : Arrays.stream(type.getPermittedSubclasses()).flatMap(EntryCodecTest::records);
  }

  @Test
  void everyKindOfEntryAndMessageHasItsForm() throws ReflectiveOperationException {
    for (Class<?> type :
        Stream.of(Message.class, Entry.class).flatMap(EntryCodecTest::records).toList()) {
      RecordComponent[] parts = type.getRecordComponents();
      List<Class<?>> types = new ArrayList<>();
      List<Object> values = new ArrayList<>();
      for (RecordComponent part : parts) {
        types.add(part.getType());
        values.add(sample(part.getType()));
      }
      var constructor = type.getDeclaredConstructor(types.toArray(Class[]::new));
      Object entry = constructor.newInstance(values.toArray());
      Object copy = copy(entry);
      assertEquals(type, copy.getClass());
      for (RecordComponent part : parts) {
        assertArrayEquals(
            new Object[] {part.getAccessor().invoke(entry)},
            new Object[] {part.getAccessor().invoke(copy)},
            part.toString());
      }
    }
  }

  private static Throwable copy(Throwable failure) {
    return ((Outcome.Failure) copy(new Outcome.Failure(failure))).thrown();
  }

  private static Outcome copy(Outcome outcome) {
    return ((Entry.QueryAnswered) copy(new Entry.QueryAnswered(outcome))).outcome();
  }

  @Test
  void whatTheMachineShowsIsReadAgain() {
    for (Object value :
        Arrays.asList(
            null,
            true,
            false,
            1,
            2L,
            3.5,
            "text",
            Path.of("a/b"),
            List.of("a", 1),
            Map.of("k", "v"))) {
      assertEquals(Outcome.value(value), copy(Outcome.value(value)));
    }
  }

  /** A replay would not have it. */
  @Test
  void whatIsNoDataIsRefused() {
    for (Object live :
        List.of(new Object(), new ByteArrayInputStream(new byte[0]), Map.of("k", this))) {
      assertThrows(IllegalArgumentException.class, () -> new Data(live));
      assertThrows(IllegalArgumentException.class, () -> new DataWriter().any(live));
      assertInstanceOf(Outcome.Failure.class, Outcome.of(() -> live));
    }
  }

  @Test
  void whatTheMachineRefusesIsReadAgain() {
    Throwable none = copy(new NoSuchFileException("f", null, "why"));
    assertEquals("f", assertInstanceOf(NoSuchFileException.class, none).getFile());
    assertEquals("full", copy(new IOException("full")).getMessage());
    assertEquals("bad", copy(new IllegalStateException("bad")).getMessage());
  }

  @Test
  void anUnknownKindIsRefused() {
    assertThrows(
        RecordingException.class, () -> EntryCodec.read(new DataReader(new byte[] {(byte) 250})));
  }
}
