package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.embed.UrbiError;

/** Evaluates code in a kernel of its own, in simulated time, and gives its values to Java. */
public final class Evaluator implements AutoCloseable {
  private final Kernel kernel = Kernel.builder().virtualTime(true).log(line -> {}).start();

  /** The value of the last statement. */
  public @Nullable Object value(String code) {
    return kernel.eval(code);
  }

  /** The error with which the code ends. */
  public UrbiError error(String code) {
    return assertThrows(UrbiError.class, () -> kernel.eval(code), code);
  }

  /** A list of numbers, as code returns it. */
  public static List<Object> numbers(double... numbers) {
    return List.of(Arrays.stream(numbers).boxed().toArray());
  }

  @Override
  public void close() {
    kernel.close();
  }
}
