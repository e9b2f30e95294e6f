package urbi;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.stream.Collectors;

/**
 * Numbers as a binary: eight bytes for each, lowest first, under the header {@code packed 8 d},
 * with rows and columns after that for a matrix.
 *
 * @param rows 0 for a vector
 * @param columns 0 for a vector
 */
record PackedNumbers(int rows, int columns, double[] numbers) {
  private static final String HEADER = "packed " + Double.BYTES + " d";

  static PackedNumbers of(double... vector) {
    return new PackedNumbers(0, 0, vector);
  }

  /**
   * Reads such a binary.
   *
   * @param type what it is read for, in the error
   * @throws UCastException if it is another one
   */
  static PackedNumbers read(UBinary binary, String type) {
    byte[] data = binary.getData();
    boolean known =
        binary.getMessage().equals(HEADER) || binary.getMessage().startsWith(HEADER + " ");
    if (!known || data.length % Double.BYTES != 0) {
      throw UCastException.to(type, new UValue(binary));
    }
    double[] numbers = new double[data.length / Double.BYTES];
    ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN).asDoubleBuffer().get(numbers);
    var words = new BinaryHeaderReader(binary.getMessage().substring("packed ".length()));
    words.skip();
    return new PackedNumbers(words.number(), words.number(), numbers);
  }

  UBinary binary() {
    ByteBuffer data =
        ByteBuffer.allocate(Math.multiplyExact(numbers.length, Double.BYTES))
            .order(ByteOrder.LITTLE_ENDIAN);
    data.asDoubleBuffer().put(numbers);
    String size = rows == 0 && columns == 0 ? "" : " " + rows + " " + columns;
    return new UBinary(HEADER + size, data.array());
  }

  static String text(double... numbers) {
    return Arrays.stream(numbers)
        .mapToObj(number -> new UValue(number).toString())
        .collect(Collectors.joining(", "));
  }
}
