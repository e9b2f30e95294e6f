package org.urbi.server.options;

import java.util.List;
import picocli.CommandLine.ParseResult;

/** A command line that was understood. */
public final class Arguments {
  private final ParseResult parsed;

  Arguments(ParseResult parsed) {
    this.parsed = parsed;
  }

  /** Whether the option was given. */
  public boolean has(String option) {
    return parsed.hasMatchedOption(option);
  }

  /** The value of the option, or another one if it was not given. */
  public String value(String option, String otherwise) {
    return parsed.matchedOptionValue(option, otherwise);
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
    return parsed.matchedPositionalValue(0, List.of());
  }
}
