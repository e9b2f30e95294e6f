package org.urbi.bench;

/** The unit of a figure. */
enum Unit {
  /** Nanoseconds; shown as what is easiest to read. */
  TIME {
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
  MEMORY {
    @Override
    String text(double value) {
      return "%.1f MB".formatted(value / 1e6);
    }
  };

  /** A figure with its unit. */
  abstract String text(double value);
}
