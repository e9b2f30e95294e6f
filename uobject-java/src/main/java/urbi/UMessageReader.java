package urbi;

import java.io.ByteArrayOutputStream;

/**
 * Splits the output of a server, however it is fragmented, into messages: lines, and the data of
 * binaries, which follow a line that ends in {@code BIN size header}.
 */
final class UMessageReader {
  /** Receives the messages. */
  interface Sink {
    void message(int timestamp, String tag, UMessageType type, byte[] raw, boolean continuation);
  }

  private static final int MAX_LINE = 64 << 20;
  private static final int MAX_BINARY = 1 << 30;

  private final Sink sink;
  private final ByteArrayOutputStream line = new ByteArrayOutputStream();

  /** Where the text after the data of the last binary starts in the line. */
  private int scanned;

  private int data;
  private int timestamp;
  private String tag = "";
  private UMessageType type = UMessageType.MESSAGE_DATA;

  UMessageReader(Sink sink) {
    this.sink = sink;
  }

  /**
   * Takes bytes.
   *
   * @throws UParseException if they cannot come from a server
   */
  void feed(byte[] bytes, int from, int end) {
    int at = from;
    while (at < end) {
      if (data > 0) {
        int size = Math.min(data, end - at);
        line.write(bytes, at, size);
        data -= size;
        at += size;
        if (data == 0) {
          scanned = line.size();
        }
        continue;
      }
      int stop = at;
      while (stop < end && bytes[stop] != '\n') {
        stop++;
      }
      line.write(bytes, at, stop - at);
      if (line.size() - scanned > MAX_LINE) {
        throw new UParseException("a line has no end", line.size());
      }
      at = stop;
      if (stop < end) {
        at++;
        endOfLine();
      }
    }
  }

  private void endOfLine() {
    byte[] bytes = line.toByteArray();
    int size = binaryAtEnd(bytes);
    if (size >= 0) {
      line.write('\n');
      data = size;
      scanned = line.size();
      return;
    }
    line.reset();
    scanned = 0;
    int length = bytes.length;
    if (length > 0 && bytes[length - 1] == '\r') {
      length--;
    }
    dispatch(bytes, length);
  }

  private void dispatch(byte[] bytes, int length) {
    int start = header(bytes, length);
    boolean continuation = start < 0;
    if (continuation) {
      start = 0;
    } else {
      type = typeOf(bytes, start, length);
    }
    byte[] raw = new byte[length - start];
    System.arraycopy(bytes, start, raw, 0, raw.length);
    sink.message(timestamp, tag, type, raw, continuation);
  }

  private static UMessageType typeOf(byte[] bytes, int at, int length) {
    if (length - at >= 3 && bytes[at] == bytes[at + 1] && bytes[at] == bytes[at + 2]) {
      if (bytes[at] == '*') {
        return UMessageType.MESSAGE_SYSTEM;
      }
      if (bytes[at] == '!') {
        return UMessageType.MESSAGE_ERROR;
      }
    }
    return UMessageType.MESSAGE_DATA;
  }

  /** Reads {@code [timestamp:tag] }; the offset of what follows, or -1. */
  private int header(byte[] bytes, int length) {
    if (length < 3 || bytes[0] != '[') {
      return -1;
    }
    int at = 1;
    long time = 0;
    while (at < length && '0' <= bytes[at] && bytes[at] <= '9') {
      time = (time * 10 + bytes[at++] - '0') & 0x7fffffffffL;
    }
    int colon = at;
    if (at == 1 || at >= length || bytes[at] != ':' && bytes[at] != ']') {
      return -1;
    }
    while (at < length && bytes[at] != ']') {
      at++;
    }
    if (at == length) {
      return -1;
    }
    timestamp = (int) time;
    tag = colon == at ? "" : TextCoding.decode(bytes, colon + 1, at - colon - 1);
    return Math.min(length, at + (at + 1 < length && bytes[at + 1] == ' ' ? 2 : 1));
  }

  /**
   * The size of the binary whose header ends the line; -1 if there is none. Strings, and messages
   * for people, have none.
   */
  private int binaryAtEnd(byte[] bytes) {
    int at = scanned;
    if (at == 0) {
      int end = indexOf(bytes, ']');
      if (bytes.length > 0 && bytes[0] == '[' && end > 1 && bytes[1] >= '0' && bytes[1] <= '9') {
        at = end + 1;
      } else if (type != UMessageType.MESSAGE_DATA) {
        return -1;
      }
      int text = at < bytes.length && bytes[at] == ' ' ? at + 1 : at;
      if (typeOf(bytes, text, bytes.length) != UMessageType.MESSAGE_DATA) {
        return -1;
      }
    }
    boolean inString = false;
    for (; at < bytes.length; at++) {
      byte c = bytes[at];
      if (inString) {
        if (c == '\\') {
          at++;
        } else {
          inString = c != '"';
        }
      } else if (c == '"') {
        inString = true;
      } else if (c == 'B') {
        int size = binary(bytes, at);
        if (size >= 0) {
          return size;
        }
      }
    }
    return -1;
  }

  private static int indexOf(byte[] bytes, char c) {
    for (int i = 0; i < bytes.length; i++) {
      if (bytes[i] == c) {
        return i;
      }
    }
    return -1;
  }

  /**
   * The size in {@code BIN size header} that goes on to the end of the line; -1 if there is none.
   */
  private static int binary(byte[] bytes, int at) {
    if (bytes.length - at < 5
        || bytes[at + 1] != 'I'
        || bytes[at + 2] != 'N'
        || bytes[at + 3] != ' '
        || at > 0 && Character.isLetterOrDigit(bytes[at - 1])) {
      return -1;
    }
    int digit = at + 4;
    long size = 0;
    while (digit < bytes.length && '0' <= bytes[digit] && bytes[digit] <= '9') {
      size = size * 10 + bytes[digit++] - '0';
      if (size > MAX_BINARY) {
        throw new UParseException("a binary is too large", digit);
      }
    }
    boolean complete = digit == bytes.length || bytes[digit] == ' ' || bytes[digit] == '\r';
    return digit > at + 4 && complete ? (int) size : -1;
  }
}
