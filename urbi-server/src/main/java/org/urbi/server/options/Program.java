package org.urbi.server.options;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.server.Version;

/** A program: its name, its options, and what it does with them. */
public final class Program {
  /**
   * As the only argument: prints what the option declarations are the source of, besides the help:
   * {@code man}, {@code bash} or {@code zsh}.
   */
  public static final String GENERATE = "--generate=";

  /**
   * The exit status when the output could not be written: its reader has gone, the disk is full.
   */
  public static final int OUTPUT_LOST = 74;

  private final String name;
  private final String description;
  private final List<Option> options = new ArrayList<>();
  private @Nullable String argumentLabel;
  private @Nullable String argumentDescription;
  private boolean stopAtArgument;

  /**
   * Declares a program, which has {@code --help} and {@code --version} like all others.
   *
   * @param description one line for its help
   */
  public Program(String name, String description) {
    this.name = name;
    this.description = description;
  }

  /** Adds an option without a value. */
  public Program flag(String description, String... names) {
    options.add(new Option(List.of(names), null, null, description, value -> {}));
    return this;
  }

  /** Adds an option with a value; if it is repeated, the last value counts. */
  public Program option(String label, String description, String... names) {
    return each(label, description, value -> {}, names);
  }

  /** Adds an option that may be repeated; its values are taken in the order of the command line. */
  public Program each(String label, String description, Consumer<String> taker, String... names) {
    options.add(new Option(List.of(names), label, null, description, taker));
    return this;
  }

  /**
   * Adds an option whose value may be left out; it follows a {@code =}.
   *
   * @param implied the value when it is left out
   */
  public Program optional(String label, String implied, String description, String... names) {
    options.add(new Option(List.of(names), label, implied, description, value -> {}));
    return this;
  }

  /** Lets the program have arguments that are not options. */
  public Program arguments(String label, String description) {
    argumentLabel = label;
    argumentDescription = description;
    return this;
  }

  /** Makes everything after the first argument that is not an option an argument, too. */
  public Program stopAtArgument() {
    stopAtArgument = true;
    return this;
  }

  /** What each option is for, by each of its names, as the help shows it. */
  public Map<String, String> optionTexts() {
    Map<String, String> texts = new TreeMap<>();
    for (Option option : options) {
      String label = option.label() == null ? "" : " " + option.label();
      String text = String.join(", ", option.names()) + label + "\n" + option.description();
      option.names().forEach(each -> texts.put(each, text));
    }
    return texts;
  }

  /**
   * Runs the program: reads the command line, answers {@code --help} and {@code --version}, tells
   * what went wrong.
   *
   * @param body does the work and returns the exit status
   * @return the exit status
   */
  public int run(String[] args, PrintStream out, PrintStream err, ToIntFunction<Arguments> body) {
    if (args.length == 1) {
      // The classes of picocli would take longer than all the rest.
      if (args[0].equals("--version")) {
        out.print(Version.text(name));
        return written(out, err);
      }
      if (args[0].equals("--help") || args[0].equals("-h")) {
        out.print(HelpText.of(declaration()));
        return written(out, err);
      }
    }
    try {
      if (args.length == 1 && args[0].startsWith(GENERATE)) {
        out.print(generated(args[0].substring(GENERATE.length())));
        return written(out, err);
      }
      Optional<ParsedCommandLine> reading = readQuickly(args).or(() -> readFully(args, out));
      if (reading.isEmpty()) {
        return written(out, err);
      }
      reading.get().options().forEach(seen -> seen.option().taker().accept(seen.value()));
      return body.applyAsInt(new Arguments(reading.get()));
    } catch (Failure e) {
      err.println(name + ": " + e.getMessage());
      if (e.isMisuse()) {
        err.println("Try `" + name + " --help' for more information.");
      }
      return e.status();
    }
  }

  /** The exit status of a program that has answered all that was asked. */
  private int written(PrintStream out, PrintStream err) {
    if (out.checkError()) {
      err.println(name + ": cannot write the output");
      return OUTPUT_LOST;
    }
    return 0;
  }

  /** Parses a simple command line; nothing if it is not that simple. */
  Optional<ParsedCommandLine> readQuickly(String... args) {
    return new FastParser(options, stopAtArgument)
        .read(args)
        .filter(reading -> argumentLabel != null || reading.rest().isEmpty());
  }

  /** Parses any command line; nothing if the help or the version was printed. */
  Optional<ParsedCommandLine> readFully(String[] args, PrintStream out) {
    return new PicocliParser(declaration())
        .read(
            args, () -> out.print(HelpText.of(declaration())), () -> out.print(Version.text(name)));
  }

  private String generated(String what) {
    return switch (what) {
      case "man" -> ManualPage.of(declaration());
      case "bash" -> ShellCompletion.bash(declaration());
      case "zsh" -> ShellCompletion.zsh(declaration());
      default -> throw Failure.usage("invalid --generate: " + what + " (man, bash or zsh)");
    };
  }

  private Declaration declaration() {
    return new Declaration(
        name, description, options, argumentLabel, argumentDescription, stopAtArgument);
  }
}
