package org.urbi.tests;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;

/** Removes from a kernel's output what may differ between two correct runs. */
public final class OutputNormalizer {
  private static final Pattern STAMP = Pattern.compile("^\\[\\d{8,}");
  private static final Pattern LOCATION =
      Pattern.compile(
          "^(\\[\\d+:error] !!! +(?:called from: )?)(?:\\S*:)?\\d+\\.\\d+(?:-(?:\\d+\\.)?\\d+)?: ");
  private static final Pattern ADDRESS = Pattern.compile("0x[0-9a-fA-F]+");
  private static final Pattern NUMBERED = Pattern.compile("\\b(shell|job|tag)_\\d+");

  private OutputNormalizer() {}

  /**
   * Lines that can be compared with {@code equals}: addresses are renamed in the order in which
   * they appear, so that the same address stays the same and different ones stay different; the
   * numbers in the names of jobs and anonymous tags go; time stamps and locations go unless they
   * are asked for; lines without a time stamp continue the one before.
   */
  public static List<String> comparable(
      List<String> lines, boolean withTimes, boolean withLocations) {
    Map<String, String> addresses = new HashMap<>();
    List<String> result = new ArrayList<>();
    for (String line : lines) {
      if (!Transcript.isOutput(line)) {
        line = "[:]" + line;
      }
      if (!withTimes) {
        line = STAMP.matcher(line).replaceFirst("[00000000");
      }
      if (!withLocations) {
        line = LOCATION.matcher(line).replaceFirst("$1");
      }
      line =
          ADDRESS
              .matcher(line)
              .replaceAll(
                  m -> addresses.computeIfAbsent(m.group(), a -> "0x<" + addresses.size() + ">"));
      line = NUMBERED.matcher(line).replaceAll("$1_N");
      result.add(line.stripTrailing());
    }
    return result;
  }
}
