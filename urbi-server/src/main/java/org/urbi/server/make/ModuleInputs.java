package org.urbi.server.make;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.urbi.server.options.Failure;

/**
 * The input files of a module, by kind. Folders are searched recursively.
 *
 * @param sources to be compiled
 * @param classes compiled already
 * @param libraries jars, whose contents become a part of the module
 * @param others files of another kind in the folders: perhaps what the classes read as resources
 */
record ModuleInputs(Set<Path> sources, Set<Path> classes, Set<Path> libraries, Set<Path> others) {
  private ModuleInputs() {
    this(
        new LinkedHashSet<>(), new LinkedHashSet<>(), new LinkedHashSet<>(), new LinkedHashSet<>());
  }

  /**
   * Collects the files that the command line names.
   *
   * @param names files and folders; none for the current folder
   * @param searched where files that are not here are looked for
   * @param output is made of the others, and never one of them
   * @throws Failure if one is missing or of another kind, or if there is nothing to be compiled or
   *     packed
   */
  static ModuleInputs gather(List<String> names, List<Path> searched, Path output) {
    ModuleInputs found = new ModuleInputs();
    List<String> wanted = names.isEmpty() ? List.of(".") : names;
    for (String name : wanted) {
      Path path = find(name, searched);
      if (Files.isDirectory(path)) {
        found.addFolder(path, output);
      } else if (!found.add(path)) {
        throw Failure.usage(
            "neither a source (.java), nor a class, nor a jar, nor a folder: " + name);
      }
    }
    if (found.sources.isEmpty() && found.classes.isEmpty() && found.libraries.isEmpty()) {
      throw Failure.of("no Java sources in " + String.join(", ", wanted));
    }
    return found;
  }

  private static Path find(String name, List<Path> searched) {
    Path path = Path.of(name);
    if (Files.exists(path)) {
      return path;
    }
    return searched.stream()
        .map(folder -> folder.resolve(name))
        .filter(Files::exists)
        .findFirst()
        .orElseThrow(() -> Failure.of("no such file: " + name));
  }

  private void addFolder(Path folder, Path output) {
    Path made = output.toAbsolutePath().normalize();
    try (Stream<Path> walk = Files.walk(folder)) {
      walk.filter(Files::isRegularFile)
          .filter(file -> !isHidden(folder.relativize(file)))
          .filter(file -> !file.toAbsolutePath().normalize().equals(made))
          .sorted()
          .map(Path::normalize)
          .forEach(file -> {
            if (!add(file)) {
              others.add(file);
            }
          });
    } catch (IOException e) {
      throw Failure.of("cannot read " + folder + ": " + e.getMessage());
    }
  }

  /** Files and folders that begin with a dot belong to other tools. */
  private static boolean isHidden(Path below) {
    for (Path part : below) {
      if (part.toString().startsWith(".")) {
        return true;
      }
    }
    return false;
  }

  /** Adds a file if its kind is known. */
  private boolean add(Path file) {
    Set<Path> kind =
        switch (file.toString().replaceFirst(".*\\.", "")) {
          case "java" -> sources;
          case "class" -> classes;
          case "jar" -> libraries;
          default -> null;
        };
    if (kind == null) {
      return false;
    }
    kind.add(file);
    return true;
  }

  /** The class path for the sources: the jars, and more. */
  List<Path> classPath(List<Path> more) {
    List<Path> path = new ArrayList<>(libraries);
    path.addAll(more);
    return path;
  }
}
