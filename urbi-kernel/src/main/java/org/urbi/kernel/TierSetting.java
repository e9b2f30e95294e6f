package org.urbi.kernel;

import org.jspecify.annotations.Nullable;

/** Reads what the user says about the compilation of hot code. */
final class TierSetting {
  private static final int DEFAULT = 100;

  private TierSetting() {}

  /** After how many calls code is compiled; 0 for never. */
  static int threshold() {
    return number(System.getProperty("urbi.tier", System.getenv("URBI_TIER")), DEFAULT);
  }

  /** How often compiled code is distrusted; 0 for never. Only tests say so. */
  static int doubt() {
    return number(System.getProperty("urbi.tier.doubt"), 0);
  }

  private static int number(@Nullable String said, int otherwise) {
    if (said == null || said.isBlank()) {
      return otherwise;
    }
    if (said.strip().equals("off")) {
      return 0;
    }
    try {
      return Math.max(0, Integer.parseInt(said.strip()));
    } catch (NumberFormatException e) {
      return otherwise;
    }
  }
}
