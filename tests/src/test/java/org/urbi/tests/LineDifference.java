package org.urbi.tests;

import java.util.List;

/**
 * Two lists of lines in one text: common lines, missing ones ({@code -}), extra ones ({@code +}).
 */
public final class LineDifference {
  private LineDifference() {}

  /** Shows what has to be done to the expected lines to get the actual ones. */
  public static String of(List<String> expected, List<String> actual) {
    int[][] common = commonLengths(expected, actual);
    StringBuilder text = new StringBuilder("--- expected\n+++ answered\n");
    int i = 0;
    int j = 0;
    while (i < expected.size() || j < actual.size()) {
      if (i < expected.size() && j < actual.size() && expected.get(i).equals(actual.get(j))) {
        line(text, ' ', expected.get(i));
        i++;
        j++;
      } else if (j == actual.size()
          || (i < expected.size() && common[i + 1][j] >= common[i][j + 1])) {
        line(text, '-', expected.get(i++));
      } else {
        line(text, '+', actual.get(j++));
      }
    }
    return text.toString();
  }

  /** {@code [i][j]}: the length of the longest common part of the lines from i and from j on. */
  private static int[][] commonLengths(List<String> a, List<String> b) {
    int[][] lengths = new int[a.size() + 1][b.size() + 1];
    for (int i = a.size() - 1; 0 <= i; i--) {
      for (int j = b.size() - 1; 0 <= j; j--) {
        lengths[i][j] =
            a.get(i).equals(b.get(j))
                ? lengths[i + 1][j + 1] + 1
                : Math.max(lengths[i + 1][j], lengths[i][j + 1]);
      }
    }
    return lengths;
  }

  private static void line(StringBuilder text, char mark, String line) {
    text.append(mark).append(' ').append(line).append('\n');
  }
}
