package org.urbi.server.options;

import java.util.List;

/** A command line that was understood. */
public final class Arguments {
  private final Reading reading;

  Arguments(Reading reading) {
    this.reading = reading;
  }

  /** Whether the option was given. */
  public boolean has(String option) {
    return reading.options().stream().anyMatch(seen -> seen.option().names().contains(option));
  }

  /** The last value of the option, or another one if it was not given. */
  public String value(String option, String otherwise) {
    String value = otherwise;
    for (Reading.Occurrence seen : reading.options()) {
      if (seen.option().names().contains(option)) {
        value = seen.value();
      }
    }
    return value;
  }

  /**
   * The value of an option that is a number.
   *
   * @throws Failure if it is not a number from {@code least} to {@code most}
   */
  public int number(String option, int otherwise, int least, int most) {
    String text = value(option, null);
    return text == null ? otherwise : number(option, text, least, most);
  }

  /**
   * Reads a number.
   *
   * @param what whose value it is, for the message
   * @throws Failure if it is not a number from {@code least} to {@code most}
   */
  public static int number(String what, String text, int least, int most) {
    try {
      int number = Integer.parseInt(text.strip());
      if (number >= least && number <= most) {
        return number;
      }
    } catch (NumberFormatException e) {
      // Answered below, like a number that is out of range.
    }
    String range =
        most == Integer.MAX_VALUE
            ? "a number, " + least + " or more"
            : "a number from " + least + " to " + most;
    throw Failure.usage("invalid " + what + ": " + text + " (" + range + ")");
  }

  /** The arguments that are not options, in order. */
  public List<String> rest() {
    return List.copyOf(reading.rest());
  }
}
