package urbi;

/** The kinds of messages that a server sends. */
public enum UMessageType {
  /** Starts with {@code ***}. */
  MESSAGE_SYSTEM,
  /** Starts with {@code !!!}. */
  MESSAGE_ERROR,
  /** All others. */
  MESSAGE_DATA
}
