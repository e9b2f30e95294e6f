package urbi;

import java.util.Arrays;
import java.util.Objects;

/**
 * Numbers in rows and columns. As a value it is a binary of packed numbers; it can be made of such
 * a binary and of a list of rows.
 */
public final class UMatrix {
  private final int rows;
  private final int columns;
  private final double[] numbers;

  /** Zeros. */
  public UMatrix(long rows, long columns) {
    this(
        Math.toIntExact(rows),
        Math.toIntExact(columns),
        new double[Math.toIntExact(Math.multiplyExact(rows, columns))]);
  }

  private UMatrix(int rows, int columns, double... numbers) {
    this.rows = rows;
    this.columns = columns;
    this.numbers = numbers;
  }

  /**
   * The matrix that a value holds.
   *
   * @throws UCastException if it is neither packed numbers with their size nor a list of rows
   */
  static UMatrix of(UValue value) {
    return switch (value.getType()) {
      case DATA_BINARY -> {
        PackedNumbers packed = PackedNumbers.read(value.ubinaryValue(), "UMatrix");
        if ((long) packed.rows() * packed.columns() != packed.numbers().length) {
          throw UCastException.to("UMatrix", value);
        }
        yield new UMatrix(packed.rows(), packed.columns(), packed.numbers());
      }
      case DATA_LIST -> ofRows(value);
      default -> throw UCastException.to("UMatrix", value);
    };
  }

  private static UMatrix ofRows(UValue value) {
    UList rows = value.ulistValue();
    int columns = rows.isEmpty() ? 0 : rows.getFirst().ulistValue().size();
    UMatrix made = new UMatrix(rows.size(), columns);
    for (int row = 0; row < rows.size(); row++) {
      UList numbers = rows.get(row).ulistValue();
      if (numbers.size() != columns) {
        throw UCastException.to("UMatrix", value);
      }
      for (int column = 0; column < columns; column++) {
        made.set(row, column, numbers.get(column).doubleValue());
      }
    }
    return made;
  }

  UValue toUValue() {
    return new UValue(new PackedNumbers(rows, columns, numbers).binary());
  }

  /** The number of rows. */
  public int size1() {
    return rows;
  }

  /** The number of columns. */
  public int size2() {
    return columns;
  }

  public double get(int row, int column) {
    return numbers[index(row, column)];
  }

  public void set(int row, int column, double number) {
    numbers[index(row, column)] = number;
  }

  private int index(int row, int column) {
    return Math.addExact(
        Math.multiplyExact(Objects.checkIndex(row, rows), columns),
        Objects.checkIndex(column, columns));
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof UMatrix that
        && rows == that.rows
        && columns == that.columns
        && Arrays.equals(numbers, that.numbers);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(numbers) + columns;
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("<");
    for (int row = 0; row < rows; row++) {
      double[] numbersOfRow = Arrays.copyOfRange(numbers, row * columns, (row + 1) * columns);
      text.append(row == 0 ? "<" : ", <").append(PackedNumbers.text(numbersOfRow)).append('>');
    }
    return text.append('>').toString();
  }
}
