package org.urbi.server.options;

import java.io.PrintStream;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.urbi.server.Version;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.ParameterException;

/** A program: its name, its options, and what it does with them. */
public final class Program {
  private final CommandSpec spec = CommandSpec.create();

  /**
   * Declares a program, which has {@code --help} and {@code --version} like all others.
   *
   * @param description one line for its help
   */
  public Program(String name, String description) {
    spec.name(name);
    spec.usageMessage()
        .description(description)
        .sortOptions(false)
        .abbreviateSynopsis(true)
        .width(100);
    spec.addOption(
        OptionSpec.builder("-h", "--help")
            .usageHelp(true)
            .description("Show this help and exit.")
            .build());
    spec.addOption(
        OptionSpec.builder("--version")
            .versionHelp(true)
            .description("Show the version and exit.")
            .build());
  }

  /** Adds an option without a value. */
  public Program flag(String description, String... names) {
    spec.addOption(OptionSpec.builder(names).description(description).build());
    return this;
  }

  /** Adds an option with a value. */
  public Program option(String label, String description, String... names) {
    spec.addOption(
        OptionSpec.builder(names)
            .type(String.class)
            .paramLabel(label)
            .description(description)
            .build());
    return this;
  }

  /** Adds an option that may come often; its values are taken in the order of the command line. */
  public Program each(String label, String description, Consumer<String> taker, String... names) {
    spec.addOption(
        OptionSpec.builder(names)
            .arity("1")
            .type(String.class)
            .paramLabel(label)
            .description(description)
            .parameterConsumer((values, option, command) -> {
              if (values.isEmpty()) {
                throw new ParameterException(
                    command.commandLine(),
                    "Missing required parameter for option '%s' (%s)"
                        .formatted(String.join("' / '", names), label));
              }
              taker.accept(values.pop());
            })
            .build());
    return this;
  }

  /** Lets the program have arguments that are not options. */
  public Program arguments(String label, String description) {
    spec.addPositional(
        PositionalParamSpec.builder()
            .index("0..*")
            .arity("0..*")
            .type(List.class)
            .auxiliaryTypes(String.class)
            .paramLabel(label)
            .hideParamSyntax(true)
            .description(description)
            .build());
    return this;
  }

  /** Makes everything after the first argument that is not an option an argument, too. */
  public Program stopAtArgument() {
    spec.parser().stopAtPositional(true);
    return this;
  }

  /**
   * Runs the program: reads the command line, answers {@code --help} and {@code --version}, tells
   * what went wrong.
   *
   * @param body does the work and returns the exit status
   * @return the exit status
   */
  public int run(String[] args, PrintStream out, PrintStream err, ToIntFunction<Arguments> body) {
    CommandLine line = new CommandLine(spec);
    try {
      CommandLine.ParseResult parsed = line.parseArgs(args);
      if (parsed.isUsageHelpRequested()) {
        line.usage(out);
        return 0;
      }
      if (parsed.isVersionHelpRequested()) {
        out.print(Version.text(spec.name()));
        return 0;
      }
      return body.applyAsInt(new Arguments(parsed));
    } catch (ParameterException e) {
      return complain(err, Failure.usage(e.getMessage()));
    } catch (Failure e) {
      return complain(err, e);
    }
  }

  private int complain(PrintStream err, Failure failure) {
    err.println(spec.name() + ": " + failure.getMessage());
    if (failure.isMisuse()) {
      err.println("Try '" + spec.name() + " --help' for more information.");
    }
    return failure.status();
  }
}
