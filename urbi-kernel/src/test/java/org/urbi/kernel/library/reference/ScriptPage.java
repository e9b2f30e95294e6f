package org.urbi.kernel.library.reference;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The page of a library that is written in urbiscript, made of the comments that begin with three
 * slashes, and of a text with examples. A class or function whose comment has two slashes is there
 * for the library alone.
 */
final class ScriptPage {
  private static final Path FOLDER = Path.of("..", "share", "urbi");

  /** A class or a function that begins here: its indentation, kind, name and the rest. */
  private static final Pattern DECLARATION =
      Pattern.compile("( *)(class|function) ('[^']+'|[\\w.]+)(.*)");

  /** A class that is a name for what devices do, and has nothing of its own. */
  private static final Pattern EMPTY = Pattern.compile(": ([\\w.]+) \\{}.*");

  private static final Pattern OPTIONAL = Pattern.compile("(\\w+) = [^,)]+");

  private final String file;
  private final List<String> lines;
  private final Map<String, StringBuilder> sections = new LinkedHashMap<>();
  private final List<String> silent = new ArrayList<>();
  private String owner = "";

  private ScriptPage(Path path) {
    try {
      file = path.getFileName().toString();
      lines = Files.readAllLines(path);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    write();
  }

  /** All of them, by name. */
  static List<ScriptPage> all() {
    try (Stream<Path> files = Files.list(FOLDER)) {
      return files
          .filter(file -> file.toString().endsWith(".u"))
          .sorted()
          .map(ScriptPage::new)
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The name of its file. */
  String name() {
    return file + ".md";
  }

  /** What is missing in the text with examples, in sentences. */
  List<String> missing() {
    List<String> missing = new ArrayList<>();
    sections.keySet().stream()
        .filter(name -> !examples().getOrDefault(name, "").contains("```urbiscript\n"))
        .forEach(name -> missing.add(file + ": no example for " + name));
    examples().keySet().stream()
        .filter(name -> !name.isEmpty() && !sections.containsKey(name))
        .forEach(name -> missing.add(file + ": there is no " + name));
    return missing;
  }

  /** What stands below each name in the text with examples; before the first one, below "". */
  private Map<String, String> examples() {
    Map<String, String> examples = new LinkedHashMap<>();
    String text = TypeText.resource(name()).orElse("");
    for (String part : text.replaceFirst("# .*\n", "## ``\n").split("(?m)^## `")) {
      int end = part.indexOf("`\n");
      if (end >= 0) {
        examples.put(part.substring(0, end), part.substring(end + 2).strip());
      }
    }
    return examples;
  }

  String markdown() {
    Map<String, String> examples = examples();
    StringBuilder out = new StringBuilder("# urbi/" + file + "\n\n");
    out.append(about().replaceAll("docs/(\\w+\\.md)", "[docs/$1](../$1)"));
    out.append("\n\n`load(\"urbi/").append(file).append("\")` loads it.\n");
    append(out, examples, "");
    sections.forEach((name, text) -> {
      out.append("\n## `" + name + "`\n\n").append(text.toString().stripTrailing()).append('\n');
      append(out, examples, name);
    });
    return out.toString();
  }

  private static void append(StringBuilder out, Map<String, String> examples, String name) {
    String text = examples.getOrDefault(name, "");
    if (!text.isEmpty()) {
      out.append('\n').append(text).append('\n');
    }
  }

  /** The line of the index that leads to it. */
  String item() {
    String sentence = about().replaceAll(" \\(.*?\\)", "").replaceFirst("[.,] .*|: `.*|[.:]$", "");
    return "* [urbi/" + file + "](library/" + name() + "): " + sentence + ".";
  }

  /** The classes and functions above which nothing is said. */
  List<String> silent() {
    return silent;
  }

  /** What the file says of itself, behind the line for editors. */
  private String about() {
    List<String> said = new ArrayList<>();
    for (int i = 1; lines.get(i).startsWith("//"); i++) {
      String line = lines.get(i).substring(2);
      said.add(
          line.startsWith("   ") ? "`" + line.strip().replaceFirst(",$", "") + "`" : line.strip());
    }
    return String.join(" ", said);
  }

  private void write() {
    for (int i = 0; i < lines.size(); i++) {
      Matcher declaration = DECLARATION.matcher(lines.get(i));
      if (declaration.matches()) {
        write(declaration, above(i));
      }
    }
  }

  private void write(Matcher declaration, List<String> comment) {
    String name = shown(declaration.group(3));
    Matcher empty = EMPTY.matcher(declaration.group(4));
    if (declaration.group(2).equals("function")) {
      write(name, declaration.group(4), comment);
    } else if (empty.matches()) {
      section(owner).append("* `" + name + ": " + shown(empty.group(1)) + "`\n");
    } else {
      owner = name;
      if (says(name, comment)) {
        section(name).append(text(comment)).append("\n\n");
      }
    }
  }

  private void write(String path, String rest, List<String> comment) {
    boolean operator = path.startsWith("'");
    int dot = operator ? -1 : path.lastIndexOf('.');
    String holder = dot < 0 ? owner : path.substring(0, dot);
    String name = operator ? path.replace("'", "") : path.substring(dot + 1);
    if (says(holder + "." + name, comment)) {
      section(holder).append("* `" + name + arguments(rest) + "`: " + text(comment) + "\n");
    }
  }

  private StringBuilder section(String name) {
    return sections.computeIfAbsent(name, section -> new StringBuilder());
  }

  /** Whether what is said of something is for everybody. */
  private boolean says(String name, List<String> comment) {
    if (comment.isEmpty()) {
      silent.add(file + ": " + name);
    }
    return !comment.isEmpty() && comment.getFirst().startsWith("///");
  }

  private static String text(List<String> comment) {
    return String.join(" ", comment.stream().map(line -> line.substring(3).strip()).toList());
  }

  /** The comment directly above a line. */
  private List<String> above(int line) {
    int begin = line;
    while (begin > 0 && lines.get(begin - 1).strip().startsWith("//")) {
      begin--;
    }
    return lines.subList(begin, line).stream().map(String::strip).toList();
  }

  /** How a name is used when the library is loaded. */
  private String shown(String name) {
    String global = name.replaceFirst("^(Global|gsrapi|uobjects)\\.", "");
    String first = global.replaceFirst("\\..*", "");
    boolean known =
        !name.startsWith("gsrapi.")
            || lines.stream().anyMatch(line -> line.contains("Global." + first + " = gsrapi"));
    return known ? global : name;
  }

  private static String arguments(String rest) {
    int begin = rest.indexOf('(');
    if (begin < 0) {
      return "(arguments...)";
    }
    String all = rest.substring(begin + 1, rest.indexOf(')', begin)).replace("var ", "");
    return all.isEmpty() ? "" : "(" + OPTIONAL.matcher(all).replaceAll("$1?") + ")";
  }
}
