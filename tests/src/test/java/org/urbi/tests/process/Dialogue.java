package org.urbi.tests.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.urbi.tests.LineDifference;
import org.urbi.tests.OutputNormalizer;
import org.urbi.tests.Transcript;

/**
 * A dialogue with UObjects: a transcript whose first lines tell which modules it needs ({@code //
 * modules: camera tracker}) and where they can be ({@code // plugged only}, {@code // remote
 * only}). What is between two answers is sent when the first of them has come.
 *
 * @param modules names of folders {@code NAME.uob}
 */
record Dialogue(
    String name, List<String> modules, boolean plugged, boolean remote, List<Exchange> exchanges) {
  /** Something that is said, and all the answers to it. */
  record Exchange(String input, List<String> answers) {}

  private static final String MODULES = "// modules: ";

  static Dialogue read(Path file) throws IOException {
    List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
    List<Exchange> exchanges = new ArrayList<>();
    StringBuilder input = new StringBuilder();
    List<String> answers = new ArrayList<>();
    for (String line : lines) {
      if (Transcript.isOutput(line)) {
        answers.add(line);
        continue;
      }
      if (!answers.isEmpty()) {
        exchanges.add(new Exchange(input.toString(), List.copyOf(answers)));
        input.setLength(0);
        answers.clear();
      }
      input.append(line).append('\n');
    }
    exchanges.add(new Exchange(input.toString(), List.copyOf(answers)));
    return new Dialogue(
        file.getFileName().toString().replaceFirst("\\..*", ""),
        lines.stream()
            .filter(line -> line.startsWith(MODULES))
            .flatMap(line -> List.of(line.substring(MODULES.length()).split(" ")).stream())
            .toList(),
        !lines.contains("// remote only"),
        !lines.contains("// plugged only"),
        List.copyOf(exchanges));
  }

  /** Holds the dialogue. */
  void hold(ConsoleClient client) throws IOException {
    List<String> expected = new ArrayList<>();
    List<String> answered = new ArrayList<>();
    for (Exchange exchange : exchanges) {
      expected.addAll(exchange.answers());
      client.send(exchange.input());
      while (answered.size() < expected.size()) {
        answered.add(client.line());
        check(expected, answered, answered.size());
      }
    }
    answered.addAll(client.answers(""));
    check(expected, answered, expected.size());
  }

  /** Compares at once what has been answered so far: nobody waits for what cannot come any more. */
  private void check(List<String> expected, List<String> answered, int count) {
    List<String> wanted = OutputNormalizer.comparable(expected.subList(0, count), false, false);
    List<String> got = OutputNormalizer.comparable(answered, false, false);
    if (!wanted.equals(got)) {
      throw new AssertionError(name + ":\n" + LineDifference.of(wanted, got));
    }
  }
}
