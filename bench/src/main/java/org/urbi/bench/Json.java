package org.urbi.bench;

import java.util.List;
import java.util.Map;
import java.util.StringJoiner;

/** The results for programs to read: nanoseconds and bytes. */
final class Json {
  private Json() {}

  /** The whole of them. */
  static String of(List<String> machine, List<Result> results) {
    StringJoiner rows = new StringJoiner(",\n  ", "[\n  ", "\n]");
    results.forEach(result -> rows.add(row(result)));
    StringJoiner lines = new StringJoiner(", ", "[", "]");
    machine.forEach(line -> lines.add(quoted(line)));
    return "{\"machine\": " + lines + ",\n\"results\": " + rows + "}\n";
  }

  private static String row(Result result) {
    StringJoiner fields = new StringJoiner(", ", "{", "}");
    fields.add("\"name\": " + quoted(result.name()));
    fields.add("\"title\": " + quoted(result.title()));
    fields.add("\"unit\": " + quoted(result.unit().symbol()));
    StringJoiner medians = new StringJoiner(", ", "{", "}");
    for (Map.Entry<Language, Double> figure : result.figures().entrySet()) {
      medians.add(key(figure.getKey()) + number(figure.getValue()));
    }
    fields.add("\"median\": " + medians);
    StringJoiner samples = new StringJoiner(", ", "{", "}");
    for (Map.Entry<Language, List<Double>> sample : result.samples().entrySet()) {
      samples.add(key(sample.getKey()) + sample.getValue().stream().map(Json::number).toList());
    }
    fields.add("\"samples\": " + samples);
    fields.add("\"target\": " + quoted(result.target().text()));
    fields.add("\"verdict\": " + quoted(result.verdict()));
    fields.add("\"note\": " + quoted(result.note()));
    return fields.toString();
  }

  private static String key(Language language) {
    return quoted(language.name().toLowerCase(java.util.Locale.ROOT)) + ": ";
  }

  private static String number(double value) {
    return "%.1f".formatted(value);
  }

  private static String quoted(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    for (char c : text.toCharArray()) {
      if (c == '"' || c == '\\') {
        quoted.append('\\').append(c);
      } else if (c < ' ') {
        quoted.append("\\u%04x".formatted((int) c));
      } else {
        quoted.append(c);
      }
    }
    return quoted.append('"').toString();
  }
}
