package org.urbi.bench;

/** The unit of a figure. */
enum Unit {
  /** Nanoseconds; shown as what is easiest to read. */
  TIME("ns") {
    @Override
    String text(double value) {
      if (Math.abs(value) < 1e3) {
        return "%.1f ns".formatted(value);
      }
      if (Math.abs(value) < 1e6) {
        return "%.2f us".formatted(value / 1e3);
      }
      return Math.abs(value) < 1e9
          ? "%.2f ms".formatted(value / 1e6)
          : "%.2f s".formatted(value / 1e9);
    }
  },
  /** Bytes; shown in units of a million. */
  MEMORY("bytes") {
    @Override
    String text(double value) {
      return "%.1f MB".formatted(value / 1e6);
    }
  },
  /** How many times what urbiscript takes. */
  RATIO("ratio") {
    @Override
    String text(double value) {
      return "%.2f".formatted(value);
    }
  },
  /** The power of n with which a time grows. */
  EXPONENT("exponent") {
    @Override
    String text(double value) {
      return "n^%.2f".formatted(value);
    }
  };

  private final String symbol;

  Unit(String symbol) {
    this.symbol = symbol;
  }

  /** How the results that programs read name it. */
  String symbol() {
    return symbol;
  }

  /** A figure with its unit. */
  abstract String text(double value);
}
