package org.urbi.kernel;

/** Reads what the user says about the compilation of hot code. */
final class TierSetting {
  private static final int DEFAULT = 100;

  private TierSetting() {}

  /** After how many calls code is compiled; 0 for never. */
  static int threshold() {
    String said = System.getProperty("urbi.tier", System.getenv("URBI_TIER"));
    if (said == null || said.isBlank()) {
      return DEFAULT;
    }
    if (said.strip().equals("off")) {
      return 0;
    }
    try {
      return Math.max(0, Integer.parseInt(said.strip()));
    } catch (NumberFormatException e) {
      return DEFAULT;
    }
  }
}
