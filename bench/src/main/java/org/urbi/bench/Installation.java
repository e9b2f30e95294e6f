package org.urbi.bench;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The language interpreters that are installed on this machine. */
final class Installation {
  /** Where the programs are: single constructs, and programs as people write them. */
  static final List<String> FOLDERS = List.of("programs", "everyday");

  private final Path root;
  private final List<String> flags =
      List.of(System.getProperty("bench.jvm.flags", "").strip().split("\\s+"));
  private final Map<Language, String> interpreters = new EnumMap<>(Language.class);

  Installation() {
    this(Path.of(System.getProperty("bench.root", ".")).toAbsolutePath());
  }

  /** With the project in a folder. */
  Installation(Path root) {
    this.root = root;
    for (Language language : List.of(Language.PYTHON, Language.LUA, Language.LUAJIT)) {
      language.interpreter().ifPresent(path -> interpreters.put(language, path));
    }
  }

  /** The folder of the project. */
  Path root() {
    return root;
  }

  /** A program in one of the languages, which may not exist. */
  Path program(Language language, String name) {
    for (String folder : FOLDERS) {
      Path source =
          root.resolve("bench").resolve(folder).resolve(name).resolve(name + language.suffix());
      if (Files.exists(source)) {
        return source;
      }
    }
    return root.resolve("bench/programs").resolve(name).resolve(name + language.suffix());
  }

  /** Where the results go. */
  Path results() {
    return root.resolve("bench/results");
  }

  /** The program {@code ./urbi}. */
  String urbi() {
    return root.resolve("urbi").toString();
  }

  /** The program {@code java} which runs this. */
  static String java() {
    return Path.of(System.getProperty("java.home"), "bin", "java").toString();
  }

  /** The interpreter of a language, if there is one. */
  Optional<String> interpreter(Language language) {
    return Optional.ofNullable(interpreters.get(language));
  }

  /** How to run a class of this module on a machine with the flags of {@code ./urbi}. */
  List<String> javaCommand(Class<?> main, String... arguments) {
    List<String> command = new ArrayList<>(List.of(java()));
    flags.stream().filter(flag -> !flag.isEmpty()).forEach(command::add);
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), main.getName()));
    command.addAll(List.of(arguments));
    return command;
  }

  /** What was found, one line each. */
  List<String> description() {
    List<String> lines = new ArrayList<>();
    lines.add(
        "Java "
            + Runtime.version()
            + ", "
            + System.getProperty("os.name")
            + ", "
            + Runtime.getRuntime().availableProcessors()
            + " processors");
    lines.add(
        interpreter(Language.PYTHON)
            .map(path -> Language.version(path, "--version"))
            .orElse("CPython 3 is not installed: its column is left out"));
    lines.add(
        interpreter(Language.LUA)
            .map(path -> Language.version(path, "-v"))
            .orElse("Lua 5.4 is not installed: its column is left out"));
    lines.add(
        interpreter(Language.LUAJIT)
            .map(path -> Language.version(path, "-v"))
            .orElse("LuaJIT is not installed: its column is left out"));
    return lines;
  }
}
