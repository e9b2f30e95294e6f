package org.urbi.kernel.journal;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Data;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;
import urbi.UValue;
import urbi.wire.WireInput;

/** Reads what {@link DataWriter} has written; invalid data is a {@link RecordingException}. */
final class DataReader {
  private final WireInput in;

  DataReader(byte[] bytes) {
    in = new WireInput(bytes, 0, bytes.length);
  }

  boolean hasMore() {
    return in.hasMore();
  }

  int octet() {
    return in.octet();
  }

  long number() {
    long rest = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      int octet = in.octet();
      rest |= (octet & 0x7fL) << shift;
      if (octet < 0x80) {
        return rest >>> 1 ^ -(rest & 1);
      }
    }
    throw new RecordingException("has a number without an end");
  }

  private int count() {
    long count = number();
    if (count < 0 || count > Integer.MAX_VALUE) {
      throw new RecordingException("has an impossible length");
    }
    return (int) count;
  }

  private byte[] bytes() {
    return in.bytes(count());
  }

  private String text() {
    int width = octet();
    return new String(
        bytes(), width == 1 ? StandardCharsets.ISO_8859_1 : StandardCharsets.UTF_16BE);
  }

  /** Reads a component of that type. */
  @Nullable Object part(Class<?> type) {
    if (type == int.class) {
      return (int) number();
    } else if (type == long.class) {
      return number();
    } else if (type == boolean.class) {
      return octet() == 1;
    } else if (type == double.class) {
      return Double.longBitsToDouble(in.number());
    } else if (type == byte[].class) {
      return bytes();
    } else if (type == UValue[].class) {
      return in.values();
    } else if (type == Message.class) {
      return EntryCodec.read(this);
    } else if (type == Outcome.class) {
      return outcome();
    } else if (type == Data.class) {
      return new Data(any());
    } else if (type.isEnum()) {
      return constant(type.getEnumConstants());
    }
    return any();
  }

  private Object constant(Object[] all) {
    int number = count();
    if (number >= all.length) {
      throw new RecordingException("has an unknown constant");
    }
    return all[number];
  }

  private Outcome outcome() {
    int kind = octet();
    return kind == 0 ? Outcome.value(any()) : new Outcome.Failure(FailureCodec.read(kind, this));
  }

  /** Reads a value, which starts with the number of its type. */
  @Nullable Object any() {
    int kind = octet();
    return switch (kind) {
      case DataWriter.NULL -> null;
      case DataWriter.FALSE -> false;
      case DataWriter.TRUE -> true;
      case DataWriter.INT -> (int) number();
      case DataWriter.LONG -> number();
      case DataWriter.DOUBLE -> Double.longBitsToDouble(in.number());
      case DataWriter.TEXT -> text();
      case DataWriter.BYTES -> bytes();
      case DataWriter.PATH -> Path.of(text());
      case DataWriter.LIST -> list();
      case DataWriter.MAP -> map();
      case DataWriter.ADDRESS -> address();
      case DataWriter.UVALUE -> in.value();
      case DataWriter.DURATION -> Duration.ofSeconds(number(), number());
      case DataWriter.HANDLE -> new Data.Handle((int) number());
      default -> throw new RecordingException("has a value of an unknown kind, " + kind);
    };
  }

  private List<Object> list() {
    List<Object> list = new ArrayList<>();
    for (int left = count(); left > 0; left--) {
      list.add(any());
    }
    return list;
  }

  private Map<Object, Object> map() {
    Map<Object, Object> map = new LinkedHashMap<>();
    for (int left = count(); left > 0; left--) {
      map.put(any(), any());
    }
    return map;
  }

  private InetSocketAddress address() {
    try {
      return new InetSocketAddress(InetAddress.getByAddress(bytes()), (int) number());
    } catch (UnknownHostException e) {
      throw new RecordingException("has an invalid address");
    }
  }
}
