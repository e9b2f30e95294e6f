package org.urbi.kernel.journal;

import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Data;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;
import urbi.UValue;
import urbi.wire.WireOutput;

/** Serializes data: numbers in as few bytes as they need, strings and lists after their length. */
final class DataWriter {
  static final int NULL = 0;
  static final int FALSE = 1;
  static final int TRUE = 2;
  static final int INT = 3;
  static final int LONG = 4;
  static final int DOUBLE = 5;
  static final int TEXT = 6;
  static final int BYTES = 7;
  static final int PATH = 8;
  static final int LIST = 9;
  static final int MAP = 10;
  static final int ADDRESS = 11;
  static final int UVALUE = 12;

  static final int DURATION = 13;
  static final int HANDLE = 14;

  private final WireOutput out = new WireOutput(1 << 12);

  void octet(int value) {
    out.octet(value);
  }

  void number(long value) {
    long rest = value << 1 ^ value >> 63;
    while ((rest & ~0x7fL) != 0) {
      out.octet((int) (rest & 0x7f | 0x80));
      rest >>>= 7;
    }
    out.octet((int) rest);
  }

  private void bytes(byte[] value) {
    number(value.length);
    out.bytes(value, 0, value.length);
  }

  private void text(String value) {
    boolean narrow = value.chars().allMatch(c -> c < 256);
    octet(narrow ? 1 : 2);
    bytes(value.getBytes(narrow ? StandardCharsets.ISO_8859_1 : StandardCharsets.UTF_16BE));
  }

  /** Writes a component of that type. */
  void part(Class<?> type, Object value) {
    if (type == int.class || type == long.class) {
      number(((Number) value).longValue());
    } else if (type == boolean.class) {
      octet((Boolean) value ? 1 : 0);
    } else if (type == double.class) {
      out.number(Double.doubleToRawLongBits((Double) value));
    } else if (type == byte[].class) {
      bytes((byte[]) value);
    } else if (type == UValue[].class) {
      out.values((UValue[]) value);
    } else if (type == Message.class) {
      EntryCodec.write(this, value);
    } else if (type == Outcome.class) {
      outcome((Outcome) value);
    } else if (type == Data.class) {
      any(((Data) value).value());
    } else if (type.isEnum()) {
      number(((Enum<?>) value).ordinal());
    } else {
      any(value);
    }
  }

  private void outcome(Outcome outcome) {
    switch (outcome) {
      case Outcome.Value value -> {
        octet(0);
        any(value.data().value());
      }
      case Outcome.Failure failure -> FailureCodec.write(this, failure.thrown());
    }
  }

  /** Writes a value, starting with the number of its type. */
  void any(@Nullable Object value) {
    switch (value) {
      case null -> octet(NULL);
      case Boolean truth -> octet(truth ? TRUE : FALSE);
      case Integer number -> {
        octet(INT);
        number(number);
      }
      case Long number -> {
        octet(LONG);
        number(number);
      }
      case Double number -> {
        octet(DOUBLE);
        out.number(Double.doubleToRawLongBits(number));
      }
      case String text -> {
        octet(TEXT);
        text(text);
      }
      case byte[] bytes -> {
        octet(BYTES);
        bytes(bytes);
      }
      case Path path -> {
        octet(PATH);
        text(path.toString());
      }
      case List<?> list -> {
        octet(LIST);
        number(list.size());
        list.forEach(this::any);
      }
      case Map<?, ?> map -> {
        octet(MAP);
        number(map.size());
        map.forEach((key, each) -> {
          any(key);
          any(each);
        });
      }
      case InetSocketAddress address -> {
        octet(ADDRESS);
        bytes(address.getAddress().getAddress());
        number(address.getPort());
      }
      case UValue given -> {
        octet(UVALUE);
        out.value(given);
      }
      case Duration time -> {
        octet(DURATION);
        number(time.getSeconds());
        number(time.getNano());
      }
      case Data.Handle handle -> {
        octet(HANDLE);
        number(handle.number());
      }
      default -> throw new IllegalArgumentException(value.getClass().getName());
    }
  }

  int length() {
    return out.length();
  }

  /** Returns what has been written, and clears it. */
  byte[] take() {
    byte[] bytes = out.toBytes();
    out.reset();
    return bytes;
  }
}
