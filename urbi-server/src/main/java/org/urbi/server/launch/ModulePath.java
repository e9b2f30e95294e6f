package org.urbi.server.launch;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.urbi.server.cli.SearchPath;
import org.urbi.server.options.Failure;
import urbi.spi.ModuleFiles;

/** The folders in which modules are searched: {@code URBI_UOBJECT_PATH} (manual, section 21.1). */
record ModulePath(SearchPath path) {
  private static final String VARIABLE = "URBI_UOBJECT_PATH";
  private static final List<String> SUFFIXES =
      Stream.concat(
              Stream.concat(Stream.of(""), ModuleFiles.suffixes().stream()), Stream.of(".zip"))
          .toList();

  /**
   * The path in the environment variable; by default the current folder and the folder of the
   * components that come with urbi, which the launcher passes.
   */
  static ModulePath ofEnvironment() {
    List<Path> standard =
        Stream.of(".", System.getProperty("urbi.uobjects"))
            .filter(Objects::nonNull)
            .map(Path::of)
            .toList();
    return new ModulePath(SearchPath.of(System.getenv(VARIABLE), standard));
  }

  /**
   * Finds the jar or library of that name, or else the folder of classes; the suffix may be left
   * out.
   *
   * @return its absolute path
   * @throws Failure if there is neither
   */
  Path find(String name) {
    for (Path folder : path.directories()) {
      for (String suffix : SUFFIXES) {
        Path file = folder.resolve(name + suffix);
        if (Files.isRegularFile(file)) {
          return file.toAbsolutePath().normalize();
        }
      }
      if (Files.isDirectory(folder.resolve(name))) {
        return folder.resolve(name).toAbsolutePath().normalize();
      }
    }
    if (Path.of(name).isAbsolute()) {
      throw Failure.of("no such module: " + name);
    }
    throw Failure.of(
        "no module " + name + " in " + shown() + " (" + VARIABLE + " says where to look)");
  }

  /**
   * Finds the jar or library of that name, which can be plugged into a server.
   *
   * @throws Failure if there is none
   */
  Path findJar(String name) {
    Path found = find(name);
    if (Files.isDirectory(found)) {
      throw Failure.of(found + " is a folder, only a jar can be plugged: umake-java makes one");
    }
    return found;
  }

  private String shown() {
    return path.directories().stream()
        .map(Path::toString)
        .collect(Collectors.joining(File.pathSeparator));
  }
}
