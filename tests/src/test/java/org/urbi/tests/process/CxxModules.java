package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;

/**
 * The modules of {@code examples/uobjects-cpp}. They are compiled when first needed, and kept,
 * where scripts/memory-check has them too: the next run compiles only what has changed.
 */
final class CxxModules {
  static final Path ROOT = Path.of("..").toAbsolutePath().normalize();
  static final Path SOURCES = ROOT.resolve("examples").resolve("uobjects-cpp");

  /** Modules and dialogues for tests alone. */
  static final Path OWN = Path.of("src", "test", "native").toAbsolutePath();

  /** Has the options by which all tests that use umake compile, so that they share what is made. */
  private static final Path FLAGS =
      ROOT.resolve("uobject-native-bridge").resolve("src/test/native/cxxflags");

  private static final Path MADE = ROOT.resolve(".build").resolve("cxx");

  private final Map<String, Path> made = new ConcurrentHashMap<>();

  /** The library that {@code umake-shared} makes of {@code NAME.uob}, without a warning. */
  Path library(String name) {
    return made.computeIfAbsent(name, key -> make(key, SOURCES.resolve(key + ".uob")));
  }

  /** The library that is made of {@code NAME.uob} in {@code src/test/native}. */
  Path ownLibrary(String name) {
    return made.computeIfAbsent("own " + name, key -> own(name));
  }

  private static Path own(String name) {
    return make(name, OWN.resolve(name + ".uob"));
  }

  /** The library with all faults. */
  static Path faulty() {
    return own("faulty");
  }

  private static void assumeTools(String... tools) {
    for (String tool : tools) {
      assumeTrue(runs(tool, "--version"), "no " + tool + ": apt-get install " + tool);
    }
  }

  /** Compiles a program with the headers, and accepts no warning. */
  static void compileProgram(String compiler, Path source, Path program, String... options)
      throws IOException, InterruptedException {
    assumeTools(compiler);
    List<String> words = new ArrayList<>(List.of(compiler, "-Wall", "-Wextra", "-Werror"));
    words.addAll(List.of(options));
    words.addAll(List.of("-I", ROOT.resolve("include").toString(), source.toString()));
    words.addAll(List.of("-o", program.toString(), "-pthread"));
    assertEquals("", output(words.toArray(String[]::new)));
  }

  private static Path make(String name, Path sources) {
    try {
      Files.createDirectories(MADE);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    Path library = MADE.resolve(name + ".so");
    try {
      umake("umake-shared", "library", sources, library);
    } catch (IOException | InterruptedException e) {
      throw new AssertionError(e);
    }
    return library;
  }

  /**
   * Has umake compile sources, and accepts no warning.
   *
   * @param tool umake, or one of its sisters
   * @param kind what it says that it makes
   */
  static void umake(String tool, String kind, Path sources, Path made, String... options)
      throws IOException, InterruptedException {
    assumeTools("g++", "make");
    List<String> words = new ArrayList<>(List.of(ROOT.resolve("bin").resolve(tool).toString()));
    words.addAll(List.of(options));
    words.addAll(List.of("-q", "EXTRA_CXXFLAGS=" + Files.readString(FLAGS).strip()));
    words.addAll(List.of(sources.toString(), "-o", made.toString()));
    assertEquals("umake: running to build " + kind + ".\n", output(words.toArray(String[]::new)));
  }

  private static boolean runs(String... command) {
    try {
      output(command);
      return true;
    } catch (IOException | InterruptedException e) {
      return false;
    }
  }

  /** Runs a program, which has to end well, and returns what it has said. */
  static String output(String... command) throws IOException, InterruptedException {
    List<String> words = new ArrayList<>(List.of(command));
    Process process = new ProcessBuilder(words).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), () -> String.join(" ", words) + "\n" + output);
    return output;
  }

  /** The names of all there are. */
  static List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(SOURCES)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(".uob"))
          .map(name -> name.substring(0, name.length() - ".uob".length()))
          .sorted()
          .toList();
    }
  }
}
