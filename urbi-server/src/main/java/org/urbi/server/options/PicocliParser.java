package org.urbi.server.options;

import static java.util.Objects.requireNonNull;

import java.io.PrintStream;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Parses any command line with picocli, prints the help, and reports mistakes. */
final class PicocliParser {
  private static final int HELP_WIDTH = 100;

  private final CommandSpec spec = CommandSpec.create();
  private final List<Option> options;
  private @Nullable ParsedCommandLine reading;

  PicocliParser(Declaration program) {
    this.options = program.options();
    spec.name(program.name());
    spec.usageMessage()
        .description(plain(program.description()))
        .sortOptions(false)
        .abbreviateSynopsis(true)
        .width(HELP_WIDTH);
    spec.parser().stopAtPositional(program.stopAtArgument()).overwrittenOptionsAllowed(true);
    spec.addOption(
        OptionSpec.builder("-h", "--help").usageHelp(true).description(Declaration.HELP).build());
    spec.addOption(
        OptionSpec.builder("--version").versionHelp(true).description(Declaration.VERSION).build());
    options.forEach(option -> spec.addOption(specOf(option)));
    if (program.argumentLabel() != null) {
      spec.addPositional(
          PositionalParamSpec.builder()
              .index("0..*")
              .arity("0..*")
              .type(List.class)
              .auxiliaryTypes(String.class)
              .paramLabel(program.argumentLabel())
              .hideParamSyntax(true)
              .description(
                  plain(requireNonNull(program.argumentDescription(), "goes with its label")))
              .build());
    }
  }

  /** Picocli takes descriptions for formats. */
  private static String plain(String text) {
    return text.replace("%", "%%");
  }

  private OptionSpec specOf(Option option) {
    OptionSpec.Builder builder =
        OptionSpec.builder(option.names().toArray(String[]::new))
            .description(plain(option.description()));
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
   * The parsed command line, or nothing if the help or the version was printed.
   *
   * @throws Failure if it makes no sense
   */
  Optional<ParsedCommandLine> read(String[] args, PrintStream out, String version) {
    reading = new ParsedCommandLine();
    CommandLine line = new CommandLine(spec);
    try {
      ParseResult parsed = line.parseArgs(args);
      if (parsed.isUsageHelpRequested()) {
        line.usage(out);
        return Optional.empty();
      }
      if (parsed.isVersionHelpRequested()) {
        out.print(version);
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
      throw Failure.usage(
          unmatched.startsWith("-") ? "invalid option: " + unmatched : e.getMessage());
    } catch (ParameterException e) {
      throw Failure.usage(e.getMessage());
    }
  }
}
