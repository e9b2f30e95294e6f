package org.urbi.server.options;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What a program says of its command line: the source of its help, its manual page and its
 * completion.
 *
 * @param description one line
 * @param options those of the program itself, without {@code --help} and {@code --version}
 * @param argumentLabel what stands for other arguments in the help, or null if it takes none
 * @param stopAtArgument whether what follows the first of them is an argument, too
 */
record Declaration(
    String name,
    String description,
    List<Option> options,
    @Nullable String argumentLabel,
    @Nullable String argumentDescription,
    boolean stopAtArgument) {
  static final String HELP = "Show this help and exit.";
  static final String VERSION = "Show the version and exit.";

  /** All options, first those that every program has. */
  List<Option> allOptions() {
    List<Option> all = new ArrayList<>();
    all.add(new Option(List.of("-h", "--help"), null, null, HELP, value -> {}));
    all.add(new Option(List.of("--version"), null, null, VERSION, value -> {}));
    all.addAll(options);
    return all;
  }
}
