package urbi;

/** What a {@link UValue} holds. */
public enum UDataType {
  /** Bytes with a header: {@link UBinary}. */
  DATA_BINARY,
  /** Values by name: {@link UDictionary}. */
  DATA_DICTIONARY,
  /** A number, and Booleans, which are 1 and 0. */
  DATA_DOUBLE,
  /** Values one after the other: {@link UList}. */
  DATA_LIST,
  /** Text. */
  DATA_STRING,
  /** The name of a slot, as {@code camera.val}, or of an object. */
  DATA_SLOTNAME,
  /** Nothing. */
  DATA_VOID
}
