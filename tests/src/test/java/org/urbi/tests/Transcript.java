package org.urbi.tests;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * A dialogue as the manual prints it. Lines that begin with a time stamp in square brackets, and
 * lines that begin with {@code [:]} and go on with the one before, are what the kernel has to
 * answer; all others are what it is fed.
 *
 * <p>Comment lines of the input may ask for more than usual, or for less:
 *
 * <ul>
 *   <li>{@code // exact-times}: the time stamps count, in milliseconds of virtual time;
 *   <li>{@code // any-locations: REASON}: the locations of errors do not count.
 * </ul>
 *
 * @param input what the kernel is fed, one {@code char} per byte
 * @param expected what it has to answer, as written
 * @param exactTimes whether time stamps are compared
 * @param exactLocations whether the locations of errors are compared
 */
public record Transcript(
    String input, List<String> expected, boolean exactTimes, boolean exactLocations) {

  /** How the files end. */
  static final String SUFFIX = ".u-session";

  /** Begins the comment line which says why locations do not count. */
  private static final String ANY_LOCATIONS = "// any-locations:";

  private static final Pattern OUTPUT = Pattern.compile("\\[(\\d{8,}(:[^]]*)?|:)].*");

  static Transcript read(Path file) {
    try {
      // One char per byte: what is not ASCII reaches the kernel as it stands in the file.
      return parse(Files.readString(file, StandardCharsets.ISO_8859_1));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static Transcript parse(String text) {
    StringBuilder input = new StringBuilder();
    List<String> expected = new ArrayList<>();
    boolean exactTimes = false;
    boolean exactLocations = true;
    for (String line : text.lines().toList()) {
      if (isOutput(line)) {
        expected.add(line);
      } else {
        exactTimes |= line.equals("// exact-times");
        if (line.startsWith(ANY_LOCATIONS)) {
          if (line.length() == ANY_LOCATIONS.length()) {
            throw new IllegalArgumentException("no reason why locations do not count");
          }
          exactLocations = false;
        }
        input.append(line).append('\n');
      }
    }
    return new Transcript(input.toString(), List.copyOf(expected), exactTimes, exactLocations);
  }

  /** Whether a line of a transcript is an answer. */
  public static boolean isOutput(String line) {
    return OUTPUT.matcher(line).matches();
  }

  /** Whether there is anything but comments to feed. */
  boolean hasInput() {
    return input.lines().anyMatch(line -> !line.isBlank() && !line.startsWith("//"));
  }

  /** What is expected, without what does not count. */
  List<String> expectedLines() {
    return OutputNormalizer.comparable(expected, exactTimes, exactLocations);
  }

  /** What was answered, without what does not count. */
  List<String> answeredLines(String output) {
    return OutputNormalizer.comparable(output.lines().toList(), exactTimes, exactLocations);
  }
}
