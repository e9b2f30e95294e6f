package org.urbi.server.options;

import static java.util.Objects.requireNonNullElse;

import java.time.Duration;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** The parsed arguments of a program. */
public final class Arguments {
  private static final Pattern DURATION =
      Pattern.compile("(\\d{1,9}(?:\\.\\d{1,9})?)(ms|s|min|h|)");

  private final ParsedCommandLine reading;

  Arguments(ParsedCommandLine reading) {
    this.reading = reading;
  }

  /** Whether the option was given. */
  public boolean has(String option) {
    return reading.options().stream().anyMatch(seen -> seen.option().names().contains(option));
  }

  /** The last value of the option, or another one if it was not given. */
  public String value(String option, String defaultValue) {
    return requireNonNullElse(value(option), defaultValue);
  }

  /** The last value of the option; null if it was not given, or takes none. */
  public @Nullable String value(String option) {
    String value = null;
    for (ParsedCommandLine.Occurrence seen : reading.options()) {
      if (seen.option().names().contains(option)) {
        value = seen.value();
      }
    }
    return value;
  }

  /**
   * The value of an option that is a number.
   *
   * @throws Failure if it is not a number from {@code min} to {@code max}
   */
  public int number(String option, int defaultValue, int min, int max) {
    String text = value(option);
    return text == null ? defaultValue : number(option, text, min, max);
  }

  /**
   * Reads a number.
   *
   * @param what whose value it is, for the message
   * @throws Failure if it is not a number from {@code min} to {@code max}
   */
  public static int number(String what, String text, int min, int max) {
    try {
      int number = Integer.parseInt(text.strip());
      if (number >= min && number <= max) {
        return number;
      }
    } catch (NumberFormatException e) {
      // Reported below, like a number that is out of range.
    }
    String range =
        max == Integer.MAX_VALUE
            ? "a number, " + min + " or more"
            : "a number from " + min + " to " + max;
    throw Failure.usage("invalid " + what + ": " + text + " (" + range + ")");
  }

  /**
   * The value of an option that is a duration, as urbiscript writes it: a number, followed by
   * {@code ms}, {@code s}, {@code min} or {@code h}; seconds without a unit.
   *
   * @throws Failure if it is none
   */
  public Duration duration(String option, Duration defaultValue) {
    String text = value(option);
    if (text == null) {
      return defaultValue;
    }
    Matcher matcher = DURATION.matcher(text.strip());
    if (!matcher.matches()) {
      throw Failure.usage("invalid " + option + ": " + text + " (a duration, as 500ms or 5s)");
    }
    double milliseconds =
        Double.parseDouble(matcher.group(1))
            * switch (matcher.group(2)) {
              case "ms" -> 1;
              case "min" -> 60_000;
              case "h" -> 3_600_000;
              default -> 1000;
            };
    return Duration.ofMillis((long) Math.ceil(milliseconds));
  }

  /** The arguments that are not options, in order. */
  public List<String> rest() {
    return List.copyOf(reading.rest());
  }
}
