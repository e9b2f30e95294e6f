package org.urbi.kernel.library.reference;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.urbi.kernel.ConsoleTranscript;

/**
 * A dialogue in the text about a type: what stands between {@code ```urbiscript} and {@code ```}.
 *
 * @param lines the lines between these two
 */
record Example(List<String> lines) {
  private static final String BEGIN = "```urbiscript";
  private static final String END = "```";

  /** The examples in a text, in their order. */
  static List<Example> in(String markdown) {
    List<Example> found = new ArrayList<>();
    List<String> lines = markdown.lines().toList();
    for (int begin = lines.indexOf(BEGIN); begin >= 0; ) {
      int end = begin + lines.subList(begin, lines.size()).indexOf(END);
      found.add(new Example(lines.subList(begin + 1, end)));
      int next = lines.subList(end, lines.size()).indexOf(BEGIN);
      begin = next < 0 ? -1 : end + next;
    }
    return found;
  }

  /** It as it stands in a text. */
  String block() {
    return BEGIN + "\n" + String.join("\n", lines) + "\n" + END;
  }

  /** What the kernel is fed. */
  List<String> input() {
    return lines.stream().filter(line -> !ConsoleTranscript.isOutput(line)).toList();
  }

  /** What the kernel is expected to answer. */
  String output() {
    return lines.stream().filter(ConsoleTranscript::isOutput).collect(Collectors.joining("\n"));
  }

  /**
   * Whether it waits for another program: simulated time goes on meanwhile if the machine takes
   * long for it, so that the times of the answers say nothing.
   */
  boolean waitsForPrograms() {
    return block().matches("(?s).*(System\\.system|Process\\.new)\\(.*");
  }

  /** What a fresh kernel answers, in a directory with nothing in it. */
  String answer() {
    return answer(input());
  }

  private static String answer(List<String> input) {
    try {
      Path directory = Files.createTempDirectory("urbi-example");
      try {
        return ConsoleTranscript.runIn(directory, String.join("\n", input) + "\n");
      } finally {
        delete(directory);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void delete(Path directory) throws IOException {
    try (Stream<Path> all = Files.walk(directory)) {
      for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(path);
      }
    }
  }

  /** The example with the answers that there are, each behind the line which it answers. */
  Example renewed() {
    List<String> input = input();
    List<String> answers = answer().lines().toList();
    List<String> all = new ArrayList<>();
    int told = 0;
    for (int i = 0; i < input.size(); i++) {
      all.add(input.get(i));
      boolean last = i == input.size() - 1;
      int known = last ? answers.size() : known(answers, input.subList(0, i + 1)).orElse(told);
      while (told < known) {
        all.add(answers.get(told++));
      }
    }
    return new Example(all);
  }

  /** How many answers the first lines of the input have; nothing if they end inside a statement. */
  private static Optional<Integer> known(List<String> answers, List<String> input) {
    String text = String.join("\n", input);
    if (!text.endsWith(";") || count(text, "([{") != count(text, ")]}")) {
      return Optional.empty();
    }
    List<String> first = answer(input).lines().toList();
    int same = 0;
    while (same < first.size()
        && same < answers.size()
        && first.get(same).equals(answers.get(same))) {
      same++;
    }
    return Optional.of(same);
  }

  private static long count(String text, String characters) {
    return text.chars().filter(c -> characters.indexOf(c) >= 0).count();
  }
}
