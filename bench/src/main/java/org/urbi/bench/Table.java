package org.urbi.bench;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/** The results as a table, with a column for each language that was there. */
final class Table {
  private final List<Result> results;
  private final Set<Language> languages = new TreeSet<>();

  Table(List<Result> results) {
    this.results = results;
    languages.add(Language.URBISCRIPT);
    results.forEach(result -> languages.addAll(result.figures().keySet()));
  }

  void print(PrintStream out) {
    List<List<String>> lines = new ArrayList<>();
    lines.add(heading());
    results.forEach(result -> lines.add(line(result)));
    int columns = lines.getFirst().size();
    int[] widths = new int[columns];
    for (List<String> line : lines) {
      for (int i = 0; i < columns; i++) {
        widths[i] = Math.max(widths[i], line.get(i).length());
      }
    }
    for (List<String> line : lines) {
      StringBuilder text = new StringBuilder();
      for (int i = 0; i < columns; i++) {
        String padding = " ".repeat(widths[i] - line.get(i).length());
        boolean left = i == 0 || i >= columns - 2;
        text.append(left ? line.get(i) + padding : padding + line.get(i)).append("  ");
      }
      out.println(text.toString().stripTrailing());
    }
    for (Result result : results) {
      if (!result.note().isEmpty()) {
        out.println("! " + result.title() + ": " + result.note());
      }
    }
  }

  private List<String> heading() {
    List<String> cells = new ArrayList<>(List.of("program"));
    languages.forEach(language -> cells.add(language.label()));
    languages.stream()
        .filter(language -> language != Language.URBISCRIPT)
        .forEach(language -> cells.add("/ " + language.label()));
    cells.addAll(List.of("target", ""));
    return cells;
  }

  private List<String> line(Result result) {
    List<String> cells = new ArrayList<>(List.of(result.title()));
    for (Language language : languages) {
      Double figure = result.figures().get(language);
      cells.add(figure == null ? "-" : result.unit().text(figure));
    }
    for (Language language : languages) {
      if (language != Language.URBISCRIPT) {
        Double ratio = result.ratioTo(language);
        cells.add(ratio == null ? "-" : "%.2f".formatted(ratio));
      }
    }
    cells.addAll(List.of(result.target().text(), result.verdict()));
    return cells;
  }
}
