package org.urbi.lang.print;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FloatFormatTest {
  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "-0.0, -0",
    "1, 1",
    "-42, -42",
    "0.5, 0.5",
    "0.1, 0.1",
    "1e-6, 1e-06",
    "1e-7, 1e-07",
    "1e-11, 1e-11",
    "1e-4, 0.0001",
    "1e-5, 1e-05",
    "1e3, 1000",
    "999999, 999999",
    "1e6, 1000000",
    "1234567, 1234567",
    "1234567.5, 1.23457e+06",
    "1e100, 1e+100",
    "2.718281828, 2.71828",
    "3.14159265, 3.14159",
    "0.1234567, 0.123457",
    "0.99999999, 1",
    "999999.5, 1e+06",
    "-1.5e-300, -1.5e-300",
    "100000.5, 100000",
    "123456.7, 123457",
    "NaN, nan",
    "Infinity, inf",
    "-Infinity, -inf",
  })
  void formats(double value, String text) {
    assertEquals(text, FloatFormat.format(value));
  }
}
