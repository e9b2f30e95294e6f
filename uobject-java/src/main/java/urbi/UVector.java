package urbi;

import java.util.Arrays;

/**
 * Numbers one after the other, of a fixed count. As a value it is a binary of packed numbers; it
 * can be made of such a binary and of a list.
 */
public final class UVector {
  private final double[] numbers;

  /** So many zeros. */
  public UVector(long size) {
    this(new double[Math.toIntExact(size)]);
  }

  /**
   * @param numbers not copied
   */
  UVector(double... numbers) {
    this.numbers = numbers;
  }

  /**
   * The vector that a value holds.
   *
   * @throws UCastException if it is neither packed numbers nor a list of numbers
   */
  static UVector of(UValue value) {
    return switch (value.getType()) {
      case DATA_BINARY ->
          new UVector(PackedNumbers.read(value.ubinaryValue(), "UVector").numbers());
      case DATA_LIST ->
          new UVector(value.ulistValue().stream().mapToDouble(UValue::doubleValue).toArray());
      default -> throw UCastException.to("UVector", value);
    };
  }

  UValue toUValue() {
    return new UValue(PackedNumbers.of(numbers).binary());
  }

  public int size() {
    return numbers.length;
  }

  public double get(int index) {
    return numbers[index];
  }

  public void set(int index, double number) {
    numbers[index] = number;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof UVector that && Arrays.equals(numbers, that.numbers);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(numbers);
  }

  @Override
  public String toString() {
    return "<" + PackedNumbers.text(numbers) + ">";
  }
}
