package urbi;

import java.util.Arrays;
import java.util.Objects;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Bytes with a header that says what they are (manual, "Using binary types"): {@code jpeg 320 240},
 * {@code raw 2 44100 16 1} or what their users agree upon.
 *
 * <p>Nothing is copied: the binary, the images and sounds made from it and its maker share one
 * array.
 */
public final class UBinary {
  private static final byte[] NOTHING = {};
  private static final UBinaryType UNKNOWN = UBinaryType.BINARY_UNKNOWN;

  private String message = "";
  private byte @Nullable [] data;

  /** Where the data come from when somebody wants them; null if they were just given. */
  private @Nullable Supplier<byte[]> source;

  private int size;

  /** What somebody says it is; null to leave it to the header. */
  private @Nullable UBinaryType given;

  public UBinary() {
    this("", NOTHING);
  }

  /**
   * @param keywords the header
   * @param data the bytes; not copied
   */
  public UBinary(String keywords, byte[] data) {
    setMessage(keywords);
    setData(data);
  }

  /**
   * A binary whose data are fetched when somebody looks at them.
   *
   * @param size how many bytes they are
   */
  public UBinary(String keywords, int size, Supplier<byte[]> source) {
    setMessage(keywords);
    this.size = size;
    this.source = Objects.requireNonNull(source, "source");
  }

  /** Bytes without a header. */
  public UBinary(byte[] data) {
    this("", data);
  }

  /** A copy of a binary: its header, and a copy of its data. */
  public UBinary(UBinary other) {
    this(other.message, other.getData().clone());
  }

  public UBinary(UImage image) {
    this(image.headers(), image.getData());
  }

  public UBinary(USound sound) {
    this(sound.headers(), sound.getData());
  }

  /** What the header says it is. */
  public UBinaryType getType() {
    if (message.isEmpty()) {
      return given != null ? given : getSize() == 0 ? UBinaryType.BINARY_NONE : UNKNOWN;
    }
    String word = BinaryHeaderReader.first(message);
    if (UImageFormat.parse(word) != UImageFormat.IMAGE_UNKNOWN) {
      return UBinaryType.BINARY_IMAGE;
    }
    return USoundFormat.parse(word) == USoundFormat.SOUND_UNKNOWN
        ? UNKNOWN
        : UBinaryType.BINARY_SOUND;
  }

  /** Says what it is as long as it has no header, which tells better. */
  public void setType(UBinaryType type) {
    given = Objects.requireNonNull(type, "type");
  }

  /** The header: all that is between the size and the data. */
  public String getMessage() {
    return message;
  }

  /**
   * Sets the header.
   *
   * @throws IllegalArgumentException if it has what ends a header: a semicolon or a line end
   */
  public void setMessage(String keywords) {
    String stripped = keywords.strip();
    for (int i = 0; i < stripped.length(); i++) {
      char c = stripped.charAt(i);
      if (c == ';' || c == '\n' || c == '\r') {
        throw new IllegalArgumentException(
            "the header of a binary cannot have a semicolon or a line end: " + stripped);
      }
    }
    message = stripped;
  }

  /** The bytes; not copied. */
  public byte[] getData() {
    if (data == null) {
      data = Objects.requireNonNull(source, "what has no data has a source").get();
    }
    return data;
  }

  /** What fetches the data, as it was given; null if the data themselves were. */
  public @Nullable Supplier<byte[]> source() {
    return source;
  }

  /** Sets the bytes; not copied. */
  public void setData(byte[] bytes) {
    data = Objects.requireNonNull(bytes, "data");
    source = null;
  }

  /** How many bytes there are. */
  public int getSize() {
    return data == null ? size : data.length;
  }

  /** Forgets the bytes: whatever else has them keeps them. */
  public void deleteData() {
    setData(NOTHING);
  }

  /** Makes it empty. */
  public void clear() {
    message = "";
    given = null;
    setData(NOTHING);
  }

  /**
   * The content as an image.
   *
   * @throws UCastException if its header is not an image's
   */
  public UImage uimageValue() {
    return UImage.of(this);
  }

  /**
   * The sound that it is.
   *
   * @throws UCastException if its header is not a sound's
   */
  public USound usoundValue() {
    return USound.of(this);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof UBinary that
        && message.equals(that.message)
        && Arrays.equals(getData(), that.getData());
  }

  @Override
  public int hashCode() {
    return 31 * message.hashCode() + Arrays.hashCode(getData());
  }

  /** The binary as an urbiscript literal, one character for each byte of data. */
  @Override
  public String toString() {
    return UValueWriter.text(new UValue(this));
  }
}
