package org.urbi.server.options;

import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;

/** What shells complete of a program's command line, made from what the program declares. */
final class ShellCompletion {
  /** What stands for the name of a file in the help. */
  private static final Set<String> FILES = Set.of("FILE", "PATH", "DIRECTORY", "MODULE", "FOLDER");

  private ShellCompletion() {}

  /** A script for bash, to be sourced. */
  static String bash(Declaration program) {
    String function = "_" + program.name().replace('-', '_');
    return """
    # Completion of the command line of %1$s, for bash.
    %2$s() {
      local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} none=
      # bash takes the = of --option=value for a word of its own.
      [ "$word" != = ] || word=
      if [ "$before" = = ]; then before=${COMP_WORDS[COMP_CWORD-2]} none=yes; fi
      case $before in
    %3$s%4$s  esac
      case $none$word in
        -*) COMPREPLY=($(compgen -W "%5$s" -- "$word")) ;;
        *) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
      esac
    }
    complete -F %2$s %1$s
    """
        .formatted(
            program.name(),
            function,
            cases(
                program,
                true,
                "compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- \"$word\"); return"),
            cases(program, false, "return"),
            program.allOptions().stream()
                .flatMap(option -> option.names().stream())
                .filter(name -> name.startsWith("--"))
                .collect(Collectors.joining(" ")));
  }

  private static String cases(Declaration program, boolean files, String action) {
    String names =
        program.options().stream()
            .filter(option -> option.hasValue() && option.implied() == null)
            .filter(option -> isFile(option) == files)
            .flatMap(option -> option.names().stream())
            .collect(Collectors.joining(" | "));
    return names.isEmpty() ? "" : "    " + names + ") " + action + " ;;\n";
  }

  /** A function for zsh, to be found in {@code fpath}. */
  static String zsh(Declaration program) {
    String options =
        program.allOptions().stream()
            .flatMap(option -> option.names().stream().map(name -> zshOption(option, name)))
            .collect(Collectors.joining(" \\\n"));
    String arguments = program.argumentLabel() == null ? "" : " \\\n  '*:argument:_files'";
    return "#compdef " + program.name() + "\n_arguments -S \\\n" + options + arguments + "\n";
  }

  private static String zshOption(Option option, String name) {
    String text = "*" + name;
    if (option.hasValue()) {
      text += name.startsWith("--") ? "=" : "+";
    }
    text += "[" + plain(option.description()) + "]";
    if (option.hasValue()) {
      String label = String.valueOf(option.label()).toLowerCase(Locale.ROOT);
      text += (option.implied() == null ? ":" : "::") + plain(label) + ":";
      text += isFile(option) ? "_files" : " ";
    }
    return "  '" + text + "'";
  }

  private static boolean isFile(Option option) {
    return FILES.contains(option.label());
  }

  /** Text inside quotes and brackets. */
  private static String plain(String text) {
    return text.replace("\\", "\\\\")
        .replace("'", "’")
        .replace("[", "\\[")
        .replace("]", "\\]")
        .replace(":", "\\:");
  }
}
