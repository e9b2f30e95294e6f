package org.urbi.server.options;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.text.StringDistance;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Parses any command line with picocli, and reports mistakes. */
final class PicocliParser {
  private final CommandSpec spec = CommandSpec.create();
  private final List<Option> options;
  private @Nullable ParsedCommandLine reading;

  PicocliParser(Declaration program) {
    this.options = program.options();
    spec.name(program.name());
    spec.parser().stopAtPositional(program.stopAtArgument()).overwrittenOptionsAllowed(true);
    spec.addOption(OptionSpec.builder("-h", "--help").usageHelp(true).build());
    spec.addOption(OptionSpec.builder("--version").versionHelp(true).build());
    options.forEach(option -> spec.addOption(specOf(option)));
    if (program.argumentLabel() != null) {
      spec.addPositional(
          PositionalParamSpec.builder()
              .index("0..*")
              .arity("0..*")
              .type(List.class)
              .auxiliaryTypes(String.class)
              .paramLabel(program.argumentLabel())
              .build());
    }
  }

  private OptionSpec specOf(Option option) {
    OptionSpec.Builder builder = OptionSpec.builder(option.names().toArray(String[]::new));
    if (option.hasValue()) {
      builder
          .arity(option.implied() == null ? "1" : "0..1")
          .type(String.class)
          .paramLabel(option.label())
          .parameterConsumer((values, self, command) -> {
            String implied = option.implied();
            boolean isGiven = !values.isEmpty() && (implied == null || isNumber(values.peek()));
            if (!isGiven && implied == null) {
              throw new ParameterException(
                  command.commandLine(),
                  "Missing required parameter for option '%s' (%s)"
                      .formatted(String.join("' / '", option.names()), option.label()));
            }
            requireNonNull(reading, "it is being read")
                .options()
                .add(new ParsedCommandLine.Occurrence(option, isGiven ? values.pop() : implied));
          });
    }
    return builder.build();
  }

  /** Only a number can be the value of an option that need not have one. */
  private static boolean isNumber(String word) {
    return word.chars().allMatch(Character::isDigit);
  }

  /**
   * The parsed command line, or nothing if the help or the version is asked for.
   *
   * @param help prints the help
   * @param version prints the version
   * @throws Failure if it makes no sense
   */
  Optional<ParsedCommandLine> read(String[] args, Runnable help, Runnable version) {
    reading = new ParsedCommandLine();
    CommandLine line = new CommandLine(spec);
    try {
      ParseResult parsed = line.parseArgs(args);
      if (parsed.isUsageHelpRequested()) {
        help.run();
        return Optional.empty();
      }
      if (parsed.isVersionHelpRequested()) {
        version.run();
        return Optional.empty();
      }
      for (Option option : options) {
        if (!option.hasValue() && parsed.hasMatchedOption(option.names().getFirst())) {
          requireNonNull(reading, "it is being read")
              .options()
              .add(new ParsedCommandLine.Occurrence(option, null));
        }
      }
      List<String> rest = parsed.matchedPositionalValue(0, List.of());
      reading.rest().addAll(rest);
      return Optional.of(reading);
    } catch (UnmatchedArgumentException e) {
      String unmatched = e.getUnmatched().getFirst();
      throw Failure.usage(unmatched.startsWith("-") ? invalid(unmatched) : e.getMessage());
    } catch (ParameterException e) {
      throw Failure.usage(e.getMessage());
    }
  }

  /** {@code --prot 5000}, {@code --prot=5000}: what is unknown, and what may have been meant. */
  private String invalid(String unmatched) {
    int equals = unmatched.indexOf('=');
    String name = equals < 0 ? unmatched : unmatched.substring(0, equals);
    var closest = new StringDistance.ClosestName(name);
    if (name.startsWith("--")) {
      spec.optionsMap().keySet().stream()
          .filter(known -> known.startsWith("--"))
          .forEach(closest::consider);
    }
    String meant = closest.meant();
    return "invalid option: " + unmatched + (meant == null ? "" : "; did you mean " + meant + "?");
  }
}
