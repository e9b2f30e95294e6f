package org.urbi.lang.text;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** The similarity of words (manual, "String.distance", "String.closest"). */
public final class StringDistance {
  private static final int MOST_EDITS = 2;
  private static final int SHORT_WORD = 3;

  /** Nobody mistypes what is longer. */
  private static final int LONGEST_NAME = 100;

  private static final int LONG_PIECE = 1 << 16;

  private StringDistance() {}

  /**
   * The number of insertions, deletions, substitutions and transpositions of neighbours that make
   * one word of the other.
   *
   * @param onRow called now and then: long words take long
   */
  public static int distance(String from, String to, Runnable onRow) {
    int[] before = new int[to.length() + 1];
    int[] previous = new int[to.length() + 1];
    int[] current = new int[to.length() + 1];
    for (int j = 0; j <= to.length(); j++) {
      previous[j] = j;
    }
    for (int i = 1; i <= from.length(); i++) {
      onRow.run();
      current[0] = i;
      for (int j = 1; j <= to.length(); j++) {
        if (j % LONG_PIECE == 0) {
          onRow.run();
        }
        int cost = from.charAt(i - 1) == to.charAt(j - 1) ? 0 : 1;
        int best = Math.min(Math.min(current[j - 1], previous[j]) + 1, previous[j - 1] + cost);
        if (i > 1
            && j > 1
            && from.charAt(i - 1) == to.charAt(j - 2)
            && from.charAt(i - 2) == to.charAt(j - 1)) {
          best = Math.min(best, before[j - 2] + 1);
        }
        current[j] = best;
      }
      int[] oldest = before;
      before = previous;
      previous = current;
      current = oldest;
    }
    return previous[to.length()];
  }

  private static String lower(String text) {
    char[] chars = text.toCharArray();
    for (int i = 0; i < chars.length; i++) {
      chars[i] = lower(chars[i]);
    }
    return new String(chars);
  }

  private static char lower(char letter) {
    return 'A' <= letter && letter <= 'Z' ? (char) (letter - 'A' + 'a') : letter;
  }

  /** Which letters are in a word, whatever their case; some of them share one of the bits. */
  private static long letters(String word) {
    long letters = 0;
    for (int i = 0; i < word.length(); i++) {
      letters |= 1L << lower(word.charAt(i));
    }
    return letters;
  }

  /** The first of the most similar candidates; null if none is similar enough. */
  public static @Nullable String closest(String word, List<String> candidates, Runnable onRow) {
    String closest = null;
    int least = Integer.MAX_VALUE;
    for (String candidate : candidates) {
      int longest = Math.max(word.length(), candidate.length());
      boolean letter = Math.min(word.length(), candidate.length()) < 2;
      int most = letter ? 1 : 1 + Math.max(2, 2 * (longest / 3));
      if (2 * Math.abs(word.length() - candidate.length()) > most) {
        continue;
      }
      // The case of letters counts little.
      int edits =
          2 * distance(lower(word), lower(candidate), onRow) + (word.equals(candidate) ? 0 : 1);
      if (edits < least && edits <= most) {
        least = edits;
        closest = candidate;
      }
    }
    return closest;
  }

  /**
   * Finds the name that was probably meant: of the most similar candidates, with at most two typing
   * errors, one that is at hand, then one with a single letter more or less at its end, then the
   * last in alphabetical order (names with a dollar sign come after all others). Case is ignored,
   * unless names differ in nothing else.
   */
  public static final class ClosestName {
    private final String name;
    private final String lower;
    private final long letters;
    private final boolean open;
    private boolean known;
    private int least = MOST_EDITS + 1;
    private int rank;
    private @Nullable String meant;

    public ClosestName(String name) {
      this.name = name;
      this.lower = lower(name);
      this.letters = letters(name);
      this.open = name.length() <= LONGEST_NAME;
    }

    /** Adds a candidate; the order does not matter. */
    public void consider(String candidate) {
      consider(candidate, false);
    }

    /**
     * Adds a candidate.
     *
     * @param atHand whether it is meant rather than another one that is as similar
     */
    public void consider(String candidate, boolean atHand) {
      if (!open || known) {
        return;
      }
      int shorter = Math.min(name.length(), candidate.length());
      int most = shorter < 2 ? 0 : shorter < SHORT_WORD ? 1 : MOST_EDITS;
      if (Math.abs(candidate.length() - name.length()) > most) {
        return;
      }
      if (candidate.equals(name)) {
        known = true;
        return;
      }
      // An error brings one letter at most, and takes away one: that decides for most names.
      long others = letters(candidate);
      if (Long.bitCount(letters & ~others) > most || Long.bitCount(others & ~letters) > most) {
        return;
      }
      String other = lower(candidate);
      int edits = Math.max(1, distance(lower, other, () -> {}));
      int better = (atHand ? 2 : 0) + (edits == 1 && differsAtEnd(other) ? 1 : 0);
      if (edits <= most && (edits < least || edits == least && isBetter(candidate, better))) {
        meant = candidate;
        least = edits;
        rank = better;
      }
    }

    private boolean differsAtEnd(String candidate) {
      return candidate.startsWith(lower) || lower.startsWith(candidate);
    }

    private boolean isBetter(String candidate, int better) {
      return better == rank ? isAfter(candidate, meant) : better > rank;
    }

    private static boolean isAfter(String one, @Nullable String other) {
      if (other == null) {
        return true;
      }
      boolean dollar = one.startsWith("$");
      return dollar == other.startsWith("$") ? one.compareTo(other) > 0 : dollar;
    }

    /** The name that was meant; null when there is none, or there is one of just that name. */
    public @Nullable String meant() {
      return known ? null : meant;
    }
  }
}
