package org.urbi.kernel.external;

import static java.util.Objects.requireNonNull;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.object.Utf8Text;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;
import urbi.wire.WireException;

/**
 * Reads the messages of the binary mode. It never reads a byte twice, so a message that arrives
 * byte by byte costs no more than one that arrives whole.
 */
final class MessageReader {
  private static final int ASSIGN = 1;
  private static final int EMIT = 2;
  private static final int REPLY = 10;
  private static final int CODE = 11;

  private static final int BINARY = 0;
  private static final int DICTIONARY = 1;
  private static final int DOUBLE = 2;
  private static final int LIST = 3;
  private static final int STRING = 5;
  private static final int NAME = 6;
  private static final int VOID = 7;

  private static final int DEEPEST = 500;
  private static final long MOST_ELEMENTS = 1 << 28;

  /** A list or a dictionary whose elements have not all arrived yet. */
  private static final class Open {
    private final @Nullable UList list;
    private final @Nullable UDictionary dictionary;
    private long missing;
    private @Nullable String key;

    Open(@Nullable UList list, @Nullable UDictionary dictionary, long count) {
      this.list = list;
      this.dictionary = dictionary;
      this.missing = count;
    }

    void add(UValue value) {
      missing--;
      if (list != null) {
        list.add(value);
      } else if (dictionary != null && key != null) {
        dictionary.put(key, value);
        key = null;
      }
    }

    UValue value() {
      return list != null
          ? new UValue(list)
          : new UValue(requireNonNull(dictionary, "it is the one or the other"));
    }
  }

  private final MessageBytes in;
  private final ArrayDeque<Open> open = new ArrayDeque<>();
  private int code = -1;
  private @Nullable String name;
  private @Nullable UValue value;

  MessageReader(MessageBytes in) {
    this.in = in;
  }

  /** Whether the next byte starts a message. */
  boolean isBetween() {
    return code < 0;
  }

  static boolean isCode(int octet) {
    return octet == ASSIGN || octet == EMIT || octet == REPLY || octet == CODE;
  }

  /**
   * The next message; null when more input is needed.
   *
   * @throws WireException if the bytes are no valid message
   */
  @Nullable ExternalMessage next() {
    if (code < 0) {
      if (!in.has(1)) {
        return null;
      }
      in.begin();
      code = in.octet();
      if (!isCode(code)) {
        throw new WireException(Problem.NO_KIND_OF_MESSAGE.text(code));
      }
    }
    if (name == null) {
      name = string();
      if (name == null) {
        return null;
      }
    }
    if (code == CODE) {
      return done(new ExternalMessage.Code(name));
    }
    UValue whole = wholeValue();
    if (whole == null) {
      return null;
    }
    return switch (code) {
      case REPLY -> done(new ExternalMessage.Reply(Utf8Text.toJava(name), whole));
      case EMIT -> done(new ExternalMessage.Emit(Utf8Text.toJava(name), elements(whole)));
      default -> {
        // A time stamp, which is ignored: the kernel uses its own time.
        if (!in.has(8)) {
          yield null;
        }
        in.bytes(8);
        yield done(new ExternalMessage.Assign(Utf8Text.toJava(name), whole));
      }
    };
  }

  private static List<UValue> elements(UValue list) {
    List<UValue> elements = new ArrayList<>();
    list.ulistValue().forEach(elements::add);
    return elements;
  }

  private ExternalMessage done(ExternalMessage message) {
    code = -1;
    name = null;
    value = null;
    in.begin();
    return message;
  }

  /** A length followed by that number of bytes; null when they have not all arrived. */
  private @Nullable String string() {
    if (!in.has(2) || !in.has(2L + in.peekShort(0))) {
      return null;
    }
    int length = in.peekShort(0);
    in.bytes(2);
    return in.raw(length);
  }

  /** A length followed by that number of bytes, all of which have arrived. */
  private String wholeString() {
    return requireNonNull(string(), "it has been looked whether they are there");
  }

  /** The next value of the message; null when more input is needed. */
  private @Nullable UValue wholeValue() {
    if (value == null && code == EMIT && open.isEmpty()) {
      if (!in.has(4)) {
        return null;
      }
      open.push(new Open(new UList(), null, count(in.integer())));
    }
    while (value == null) {
      Open innermost = open.peek();
      if (innermost != null && innermost.missing == 0) {
        open.pop();
        put(innermost.value());
      } else if (innermost != null && innermost.dictionary != null && innermost.key == null) {
        String key = string();
        if (key == null) {
          return null;
        }
        innermost.key = Utf8Text.toComponent(key);
      } else if (!readOne()) {
        return null;
      }
    }
    return value;
  }

  private void put(UValue complete) {
    Open around = open.peek();
    if (around == null) {
      value = complete;
    } else {
      around.add(complete);
    }
  }

  private long count(long count) {
    if (count > MOST_ELEMENTS || open.size() >= DEEPEST) {
      throw new WireException(
          open.size() >= DEEPEST ? Problem.VALUES_TOO_DEEP.text() : Problem.LONG_LIST.text(count));
    }
    return count;
  }

  /** Reads a value, or the beginning of a list; false when more input is needed. */
  private boolean readOne() {
    if (!in.has(1)) {
      return false;
    }
    int type = in.peek(0);
    switch (type) {
      case VOID -> {
        in.octet();
        put(new UValue());
      }
      case DOUBLE -> {
        if (!in.has(9)) {
          return false;
        }
        in.octet();
        put(new UValue(in.number()));
      }
      case LIST, DICTIONARY -> {
        if (!in.has(5)) {
          return false;
        }
        in.octet();
        long count = count(in.integer());
        open.push(
            type == LIST
                ? new Open(new UList(), null, count)
                : new Open(null, new UDictionary(), count));
      }
      case STRING, NAME -> {
        if (!in.has(3) || !in.has(3L + in.peekShort(1))) {
          return false;
        }
        in.octet();
        String text = Utf8Text.toComponent(wholeString());
        put(type == STRING ? new UValue(text) : named(text));
      }
      case BINARY -> {
        return readBinary();
      }
      default -> throw new WireException(Problem.NO_KIND_OF_VALUE.text(type));
    }
    return true;
  }

  private static UValue named(String name) {
    return name.equals("nil") ? new UValue() : UValue.slotName(name);
  }

  private boolean readBinary() {
    if (!in.has(3)) {
      return false;
    }
    int head = 3 + in.peekShort(1);
    if (!in.has(head + 4L)) {
      return false;
    }
    long size = in.peekInt(head);
    if (!in.has(head + 4L + size)) {
      return false;
    }
    in.octet();
    String keywords = Utf8Text.toJava(wholeString());
    in.integer();
    byte[] data = in.bytes((int) size);
    try {
      put(new UValue(new UBinary(keywords, data)));
    } catch (IllegalArgumentException e) {
      throw new WireException(Problem.UNKNOWN_KEYWORDS.text());
    }
    return true;
  }
}
