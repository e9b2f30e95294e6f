package urbi;

import java.util.Arrays;
import java.util.Objects;

/** An image (manual, "Using binary types"). Its data are shared, not copied. */
public final class UImage {
  private static final byte[] NOTHING = {};

  private byte[] data = NOTHING;
  private int width;
  private int height;
  private UImageFormat format = UImageFormat.IMAGE_UNKNOWN;

  /** An image that has nothing yet. */
  public UImage() {}

  /**
   * @param width in pixels
   * @param height in pixels
   * @param data not copied
   */
  public UImage(UImageFormat format, int width, int height, byte[] data) {
    setImageFormat(format);
    setWidth(width);
    setHeight(height);
    setData(data);
  }

  /** A copy of an image, which shares its data. */
  public UImage(UImage other) {
    this(other.format, other.width, other.height, other.data);
  }

  static UImage of(UBinary binary) {
    String header = binary.getMessage();
    UImageFormat format = UImageFormat.parse(BinaryHeaderReader.first(header));
    if (format == UImageFormat.IMAGE_UNKNOWN) {
      throw UCastException.to("UImage", new UValue(binary));
    }
    var words = new BinaryHeaderReader(header);
    return new UImage(format, words.number(), words.number(), binary.getData());
  }

  String headers() {
    return format.format_string() + " " + width + " " + height;
  }

  /** The bytes; not copied. */
  public byte[] getData() {
    return data;
  }

  /** Sets the bytes; not copied. */
  public void setData(byte[] bytes) {
    data = Objects.requireNonNull(bytes, "data");
  }

  /** Forgets the bytes: whatever else has them keeps them. */
  public void deleteData() {
    data = NOTHING;
  }

  /** How many bytes there are. */
  public int getSize() {
    return data.length;
  }

  /** Pixels in a row. */
  public int getWidth() {
    return width;
  }

  /** Sets how many pixels are in a row; the bytes stay. */
  public void setWidth(long pixels) {
    width = Math.toIntExact(pixels);
  }

  /** Number of rows. */
  public int getHeight() {
    return height;
  }

  /** Sets how many rows there are; the bytes stay. */
  public void setHeight(long pixels) {
    height = Math.toIntExact(pixels);
  }

  public UImageFormat getImageFormat() {
    return format;
  }

  public void setImageFormat(UImageFormat other) {
    format = Objects.requireNonNull(other, "format");
  }

  /** The format's name. */
  public String format_string() {
    return format.format_string();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof UImage that
        && format == that.format
        && width == that.width
        && height == that.height
        && Arrays.equals(data, that.data);
  }

  @Override
  public int hashCode() {
    return Objects.hash(format, width, height, Arrays.hashCode(data));
  }

  /** What it is, without the data. */
  @Override
  public String toString() {
    return headers() + " (" + data.length + " bytes)";
  }
}
