package org.urbi.bench;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/** What the programs are written in. */
enum Language {
  URBISCRIPT("urbiscript", ".u", "", List.of()),
  PYTHON(
      "CPython",
      ".py",
      "import sys; print(sys.executable if sys.implementation.name == 'cpython' else '')",
      // The system's own is built with profile-guided optimisation; the first on the path often is
      // not.
      List.of("/usr/bin/python3", "python3", "python3.11")),
  LUA("Lua", ".lua", "print(_VERSION == 'Lua 5.4' and arg[0] or '')", List.of("lua5.4", "lua")),
  LUAJIT("LuaJIT", ".lua", "print(jit and 'luajit' or '')", List.of("luajit")),
  /** Virtual threads of the JDK, without any language. */
  BARE("bare JVM", "", "", List.of());

  private static final int TIMEOUT_SECONDS = 20;

  private final String label;
  private final String suffix;
  private final String probe;
  private final List<String> names;

  /**
   * @param probe a program that prints the interpreter's path, or an empty line if it will not do
   */
  Language(String label, String suffix, String probe, List<String> names) {
    this.label = label;
    this.suffix = suffix;
    this.probe = probe;
    this.names = names;
  }

  /** The heading of its column. */
  String label() {
    return label;
  }

  /** What the names of its programs end in. */
  String suffix() {
    return suffix;
  }

  /** Whether it compiles programs while they run, and so gets faster. */
  boolean warmsUp() {
    return this == URBISCRIPT || this == LUAJIT || this == BARE;
  }

  /** The path of its interpreter on this machine, past any script that stands before it. */
  Optional<String> interpreter() {
    return names.stream().flatMap(name -> real(name).stream()).findFirst();
  }

  /** The name and version of that interpreter. */
  static String version(String interpreter, String option) {
    try {
      return output(List.of(interpreter, option)).lines().findFirst().orElse(interpreter);
    } catch (IOException e) {
      return interpreter;
    }
  }

  private Optional<String> real(String name) {
    try {
      String path =
          output(suffix.equals(".lua") ? List.of(name, "-e", probe) : List.of(name, "-c", probe));
      if (path.isBlank()) {
        return Optional.empty();
      }
      return path.contains(File.separator) ? Optional.of(path.strip()) : onPath(path.strip());
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private static Optional<String> onPath(String name) {
    for (String folder : System.getenv("PATH").split(File.pathSeparator)) {
      Path file = Path.of(folder).resolve(name);
      if (Files.isExecutable(file)) {
        return Optional.of(file.toString());
      }
    }
    return Optional.empty();
  }

  private static String output(List<String> command) throws IOException {
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String text = new String(process.getInputStream().readAllBytes());
    try {
      return process.waitFor(TIMEOUT_SECONDS, TimeUnit.SECONDS) && process.exitValue() == 0
          ? text
          : "";
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "";
    }
  }
}
