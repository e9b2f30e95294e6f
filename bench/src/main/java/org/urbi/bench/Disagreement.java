package org.urbi.bench;

/** The same program has had different results in two languages: its times mean nothing. */
final class Disagreement extends Exception {
  private static final long serialVersionUID = 1L;

  private Disagreement(String message) {
    super(message, null, false, false);
  }

  /** Throws unless both results are the same. */
  static void check(Language one, String result, Language other, String its) throws Disagreement {
    if (!result.equals(its)) {
      throw new Disagreement(
          "results differ: %s %s, %s %s".formatted(one.label(), result, other.label(), its));
    }
  }
}
