package org.urbi.server.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.urbi.server.options.Failure;

/**
 * A list of folders in which files are searched: {@code URBI_PATH}, {@code URBI_UOBJECT_PATH}
 * (manual, section 21.1.1).
 */
public record SearchPath(List<Path> directories) {
  /**
   * Reads the value of a path variable: folders between colons; a lone colon (at the beginning, at
   * the end, or two together) stands for the standard path.
   *
   * @param value the variable's value, null if it is not set: the standard path
   */
  public static SearchPath of(String value, List<Path> standard) {
    if (value == null || value.isEmpty()) {
      return new SearchPath(standard);
    }
    List<Path> directories = new ArrayList<>();
    boolean inserted = false;
    for (String directory : value.split(":", -1)) {
      if (!directory.isEmpty()) {
        directories.add(Path.of(directory));
      } else if (!inserted) {
        directories.addAll(standard);
        inserted = true;
      }
    }
    return new SearchPath(List.copyOf(directories));
  }

  /**
   * The standard path of an installation: the current folder, then the library's, whose files are
   * known as {@code component.u} and {@code urbi/component.u}.
   */
  public static List<Path> standard(Path root) {
    Path share = library(root);
    return List.of(Path.of("."), share, share.resolve("urbi"));
  }

  /** Where an installation has the library's own source files. */
  public static Path library(Path root) {
    return root.resolve("share");
  }

  /**
   * Where an installation has UObjects: the current folder, its folder {@code share/uobjects}, and
   * that of the components that come with urbi, which the launcher names.
   */
  public static List<Path> standardModules(Path root) {
    List<Path> folders = new ArrayList<>(List.of(Path.of(".")));
    Path uobjects = library(root).resolve("uobjects");
    if (Files.isDirectory(uobjects)) {
      folders.add(uobjects);
    }
    String shipped = System.getProperty("urbi.uobjects");
    if (shipped != null) {
      folders.add(Path.of(shipped));
    }
    return List.copyOf(folders);
  }

  /** The first file of one of these names. */
  public Optional<Path> find(String... names) {
    for (Path directory : directories) {
      for (String name : names) {
        Path file = directory.resolve(name);
        if (Files.isRegularFile(file)) {
          return Optional.of(file);
        }
      }
    }
    return Optional.empty();
  }

  /**
   * The installation's root folder, {@code URBI_ROOT} or what the launcher says.
   *
   * @throws Failure if it is unknown
   */
  public static Path root() {
    String root = System.getProperty("urbi.root", System.getenv("URBI_ROOT"));
    if (root == null) {
      throw Failure.of("the root folder is unknown: set URBI_ROOT");
    }
    return Path.of(root);
  }
}
