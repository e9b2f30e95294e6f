package org.urbi.server.options;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * What {@code --help} prints: the names on the left, what they mean on the right. It is made
 * without picocli, whose classes would take longer than all the rest.
 */
final class HelpText {
  private static final int WIDTH = 100;

  /** Where long names begin. */
  private static final int LEFT = 6;

  /** Longer names do not move the right side any further; they may have a line of their own. */
  private static final int LONGEST = 20;

  /** Between the longest name that counts and what it means. */
  private static final int GAP = 3;

  /** By how much the second line of a meaning is indented. */
  private static final int INDENT = 2;

  private record Entry(String names, String meaning) {}

  private final StringBuilder text = new StringBuilder();
  private final int right;

  private HelpText(Declaration program) {
    List<Entry> entries = entries(program);
    right =
        entries.stream()
                .mapToInt(entry -> entry.names().length())
                .filter(length -> length <= LEFT + LONGEST)
                .max()
                .orElse(LEFT)
            + GAP;
    text.append("Usage: ").append(program.name()).append(" [OPTIONS]");
    if (program.argumentLabel() != null) {
      text.append(' ').append(program.argumentLabel());
    }
    text.append('\n');
    wrap(program.description(), 0, 0);
    entries.forEach(this::add);
  }

  /** The text, with a newline at the end of each line. */
  static String of(Declaration program) {
    return new HelpText(program).text.toString();
  }

  private static List<Entry> entries(Declaration program) {
    List<Entry> entries = new ArrayList<>();
    if (program.argumentLabel() != null && program.argumentDescription() != null) {
      entries.add(
          new Entry(" ".repeat(LEFT) + program.argumentLabel(), program.argumentDescription()));
    }
    for (Option option : program.allOptions()) {
      entries.add(new Entry(names(option), option.description()));
    }
    return entries;
  }

  private static String names(Option option) {
    String names = option.names().stream().collect(Collectors.joining(", "));
    String indented = (names.startsWith("--") ? " ".repeat(LEFT) : "  ") + names;
    if (!option.hasValue()) {
      return indented;
    }
    String value = (names.contains("--") ? "=" : " ") + option.label();
    return indented + (option.implied() == null ? value : "[" + value + "]");
  }

  private void add(Entry entry) {
    text.append(entry.names());
    int column = entry.names().length();
    if (column >= right) {
      text.append('\n');
      column = 0;
    }
    text.append(" ".repeat(right - column));
    wrap(entry.meaning(), right, right + INDENT);
  }

  /**
   * Adds words, in lines that are not too long.
   *
   * @param column where the first word is added
   * @param indent where the other lines begin
   */
  private void wrap(String words, int column, int indent) {
    int at = column;
    String space = "";
    for (String word : words.split(" ")) {
      if (at + space.length() + word.length() > WIDTH && !space.isEmpty()) {
        text.append('\n').append(" ".repeat(indent));
        at = indent;
        space = "";
      }
      text.append(space).append(word);
      at += space.length() + word.length();
      space = " ";
    }
    text.append('\n');
  }
}
