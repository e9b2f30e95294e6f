package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Compiles C++ code for tests, by umake, or as the manual says to do it by hand. */
final class CxxCompiler {
  static final Path HEADERS = Path.of("src", "main", "native", "include").toAbsolutePath();

  /** Has the options by which all tests that use umake compile, so that they share what is made. */
  private static final Path FLAGS = Path.of("src", "test", "native", "cxxflags").toAbsolutePath();

  private static final Path UMAKE =
      Path.of("..", "bin", "umake-shared").toAbsolutePath().normalize();
  static final Path MADE = Path.of("target", "cxx").toAbsolutePath();

  private CxxCompiler() {}

  /** What a process has said, and its status. */
  record Run(int status, String output) {}

  static Run run(List<String> command) {
    try {
      Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
      process.getOutputStream().close();
      String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return new Run(process.waitFor(), output);
    } catch (IOException e) {
      return new Run(127, String.valueOf(e.getMessage()));
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  static boolean exists(String command) {
    return run(List.of(command, "--version")).status() == 0;
  }

  /** Skips a test on machines that have no C++ compiler. */
  static void assumeCompiler() {
    assumeTrue(exists("g++"), "no g++: apt-get install g++");
  }

  /** The library that is made of all sources in a folder, or of one source. */
  static Path library(Path sources, String name, String... options) {
    assumeCompiler();
    try {
      Files.createDirectories(MADE);
      Path library = MADE.resolve(name + ".so");
      List<Path> files = sources(sources);
      if (!isFresh(library, files)) {
        // Other tests, in another JVM, may make or use the same one.
        Path unfinished = Files.createTempFile(MADE, name, ".so");
        compile("g++", unfinished, files, options);
        Files.move(unfinished, library, StandardCopyOption.ATOMIC_MOVE);
      }
      return library;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The source that is made of a text. */
  private static Path source(String name, String code) throws IOException {
    Files.createDirectories(MADE);
    Path source = MADE.resolve(name + ".cc");
    String whole = "#include <urbi/uobject.hh>\n" + code;
    if (!Files.exists(source) || !Files.readString(source).equals(whole)) {
      Files.writeString(source, whole);
    }
    return source;
  }

  /** The library that is made of a text by one command, as the manual says to do it by hand. */
  static Path libraryByHand(String name, String code) {
    try {
      return library(source(name, code), name);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The library that {@code umake-shared} makes of a text, without a warning. */
  static Path libraryOf(String name, String code) {
    assumeCompiler();
    assumeTrue(exists("make"), "no make: apt-get install make");
    try {
      Path source = source(name, code);
      Path library = MADE.resolve(name + ".so");
      Run made =
          run(
              List.of(
                  UMAKE.toString(),
                  "-q",
                  "EXTRA_CXXFLAGS=" + Files.readString(FLAGS).strip(),
                  source.toString(),
                  "-o",
                  library.toString()));
      assertEquals(new Run(0, "umake: running to build library.\n"), made);
      return library;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static List<Path> sources(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.filter(file -> file.toString().endsWith(".cc")).sorted().toList();
    }
  }

  private static boolean isFresh(Path library, List<Path> files) throws IOException {
    if (!Files.exists(library)) {
      return false;
    }
    List<Path> all = new ArrayList<>(files);
    try (Stream<Path> headers = Files.walk(HEADERS)) {
      headers.filter(Files::isRegularFile).forEach(all::add);
    }
    for (Path file : files) {
      try (Stream<Path> near = Files.list(file.getParent())) {
        near.filter(other -> other.toString().endsWith(".hh")).forEach(all::add);
      }
    }
    for (Path file : all) {
      if (Files.getLastModifiedTime(file).compareTo(Files.getLastModifiedTime(library)) > 0) {
        return false;
      }
    }
    return true;
  }

  /** Compiles a program, and accepts no warning. */
  static void compileProgram(String compiler, Path program, Path source, String... options) {
    List<String> command =
        new ArrayList<>(
            List.of(
                compiler, "-std=c++17", "-Wall", "-Wextra", "-Werror", "-I", HEADERS.toString()));
    command.addAll(List.of(options));
    command.addAll(List.of(source.toString(), "-o", program.toString(), "-pthread"));
    Run made = run(command);
    if (made.status() != 0) {
      throw new AssertionError(String.join(" ", command) + "\n" + made.output());
    }
  }

  /** Compiles a library, and accepts no warning. */
  static void compile(String compiler, Path library, List<Path> files, String... options) {
    List<String> command =
        new ArrayList<>(
            List.of(
                compiler,
                "-std=c++17",
                "-Wall",
                "-Wextra",
                "-Werror",
                "-I",
                HEADERS.toString(),
                "-fPIC",
                "-shared"));
    command.addAll(List.of(options));
    files.forEach(file -> command.add(file.toString()));
    command.addAll(List.of("-o", library.toString()));
    Run made = run(command);
    if (made.status() != 0) {
      throw new AssertionError(String.join(" ", command) + "\n" + made.output());
    }
  }
}
