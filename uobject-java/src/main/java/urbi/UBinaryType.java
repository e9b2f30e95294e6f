package urbi;

/** What a {@link UBinary} holds. */
public enum UBinaryType {
  /** Nothing. */
  BINARY_NONE,
  /** Bytes of which only the header tells more. */
  BINARY_UNKNOWN,
  /** A {@link UImage}. */
  BINARY_IMAGE,
  /** A {@link USound}. */
  BINARY_SOUND
}
