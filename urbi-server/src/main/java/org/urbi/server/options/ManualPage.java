package org.urbi.server.options;

import java.util.stream.Collectors;
import org.urbi.server.Version;

/** The manual page of a program, for {@code man}, made from what the program declares. */
final class ManualPage {
  private static final String STATUS =
      """
      .SH EXIT STATUS
      0 on success; 1 if something that it needs is missing, as the message says; 2 if the command
      line is wrong. A script may end with another one.
      .SH SEE ALSO
      .BR urbi (1),
      .BR urbi\\-send (1),
      .BR urbi\\-launch (1),
      .BR umake (1)
      """;

  private ManualPage() {}

  /** The page, in the language of {@code man}. */
  static String of(Declaration program) {
    StringBuilder page = new StringBuilder(head(program.name(), program.description()));
    page.append(".SH SYNOPSIS\n.B ").append(escaped(program.name())).append("\n[OPTION]...");
    if (program.argumentLabel() != null) {
      page.append(' ').append(escaped(program.argumentLabel()));
    }
    page.append("\n.SH DESCRIPTION\n").append(line(program.description()));
    if (program.argumentLabel() != null && program.argumentDescription() != null) {
      page.append(".TP\n.I ").append(escaped(program.argumentLabel())).append('\n');
      page.append(line(program.argumentDescription()));
    }
    page.append(".SH OPTIONS\n");
    program.allOptions().forEach(option -> page.append(entry(option)));
    return page.append(STATUS).toString();
  }

  private static String head(String name, String description) {
    // Lines that are not stretched to the margin: some are one long word.
    return ".TH \"%s\" 1 \"\" \"urbi %s\" \"Urbi on the JVM\"\n.ad l\n.SH NAME\n%s \\- %s\n"
        .formatted(
            escaped(name.toUpperCase(java.util.Locale.ROOT)),
            Version.number(),
            escaped(name),
            escaped(description));
  }

  private static String entry(Option option) {
    String names =
        option.names().stream()
            .map(name -> "\\fB" + escaped(name) + "\\fR" + value(option, name))
            .collect(Collectors.joining(", "));
    return ".TP\n" + names + "\n" + line(option.description());
  }

  private static String value(Option option, String name) {
    if (!option.hasValue()) {
      return "";
    }
    String label = "\\fI" + escaped(String.valueOf(option.label())) + "\\fR";
    String value = name.startsWith("--") ? "=" + label : label;
    return option.implied() == null ? value : "[" + value + "]";
  }

  /** A line of text; one that begins with a dot or an apostrophe would be a request. */
  private static String line(String text) {
    String escaped = escaped(text);
    return (escaped.startsWith(".") || escaped.startsWith("'") ? "\\&" : "") + escaped + "\n";
  }

  /** Letters beyond ASCII have a name: not every reader of pages is told their encoding. */
  private static String escaped(String text) {
    StringBuilder escaped = new StringBuilder();
    text.replace("\\", "\\e")
        .replace("-", "\\-")
        .replace("'", "\\(aq")
        .codePoints()
        .forEach(letter ->
            escaped.append(
                letter < 0x80 ? Character.toString(letter) : "\\[u%04X]".formatted(letter)));
    return escaped.toString();
  }
}
