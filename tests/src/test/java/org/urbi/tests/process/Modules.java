package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.urbi.server.make.UmakeJava;

/** The modules of {@code examples/uobjects}, compiled when first needed. */
final class Modules {
  static final Path SOURCES = Path.of("..", "examples", "uobjects").toAbsolutePath().normalize();

  private final Path folder;
  private final Map<String, Path> made = new ConcurrentHashMap<>();

  /** Makes them in a folder. */
  Modules(Path folder) {
    this.folder = folder;
  }

  /** The jar that {@code umake-java} makes of {@code NAME.uob}. */
  Path jar(String name) {
    return made.computeIfAbsent(name, this::make);
  }

  private Path make(String name) {
    Path sources = SOURCES.resolve(name + ".uob");
    if (!Files.isDirectory(sources)) {
      throw new IllegalArgumentException("no " + sources);
    }
    Path jar = folder.resolve(name + ".jar");
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    PrintStream printer = new PrintStream(output, true, StandardCharsets.UTF_8);
    String[] words = {"-q", sources.toString(), "-o", jar.toString()};
    int status = UmakeJava.run(words, printer, printer);
    assertEquals("0 ", status + " " + output.toString(StandardCharsets.UTF_8));
    return jar;
  }
}
