package urbi;

import org.jspecify.annotations.Nullable;

/**
 * A message from a server: {@code [timestamp:tag] contents}.
 *
 * <p>Text of several lines comes as several messages; all but the first are continuations, with the
 * time, tag and type of the first.
 */
public final class UMessage {
  private final UAbstractClient client;
  private final int timestamp;
  private final String tag;
  private final UMessageType type;
  private final byte[] raw;
  private final boolean continuation;
  private @Nullable UValue value;

  UMessage(
      UAbstractClient client,
      int timestamp,
      String tag,
      UMessageType type,
      byte[] raw,
      boolean continuation) {
    this.client = client;
    this.timestamp = timestamp;
    this.tag = tag;
    this.type = type;
    this.raw = raw;
    this.continuation = continuation;
  }

  /** The client that has received it. */
  public UAbstractClient getClient() {
    return client;
  }

  /** Milliseconds since the server was started. */
  public int getTimestamp() {
    return timestamp;
  }

  /** The name of the channel; empty for the one without a name. */
  public String getTag() {
    return tag;
  }

  public UMessageType getType() {
    return type;
  }

  /** Whether it is another line of the message before. */
  public boolean isContinuation() {
    return continuation;
  }

  /**
   * The value of a data message; a string of all that is there when that is no literal, and nothing
   * for messages of the system and errors.
   */
  public synchronized UValue getValue() {
    if (value == null) {
      value = read();
    }
    return value;
  }

  private UValue read() {
    if (type != UMessageType.MESSAGE_DATA) {
      return new UValue();
    }
    try {
      return UValue.parse(raw);
    } catch (UParseException e) {
      return new UValue(getRawMessage());
    }
  }

  /** The text of a message of the system or of an error, without its mark; empty for data. */
  public String getMessage() {
    if (type == UMessageType.MESSAGE_DATA) {
      return "";
    }
    String text = getRawMessage();
    return continuation || text.length() < 4 ? text : text.substring(4);
  }

  /** All that follows the time and the tag. */
  public String getRawMessage() {
    return TextCoding.decode(raw, 0, raw.length);
  }

  @Override
  public String toString() {
    String time = "0".repeat(Math.max(0, 8 - Integer.toString(timestamp).length())) + timestamp;
    return "[" + time + (tag.isEmpty() ? "" : ":" + tag) + "] " + getRawMessage();
  }
}
