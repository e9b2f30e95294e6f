package org.urbi.ros.message;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** Where the files with definitions are. */
public final class InterfaceFiles {
  /** So deep below a folder of {@code ROS_PACKAGE_PATH} packages are looked for. */
  private static final int MAX_DEPTH = 6;

  /** Longer than any such file that a person has written. */
  private static final long MAX_SIZE = 1 << 20;

  private final List<Path> folders;

  /**
   * @param folders folders of packages, or packages, the first ones first
   */
  public InterfaceFiles(List<Path> folders) {
    this.folders = List.copyOf(folders);
  }

  /** The folders that the environment of a ROS names. */
  public static InterfaceFiles of(Dialect dialect, Map<String, String> environment) {
    List<Path> folders = new ArrayList<>();
    switch (dialect) {
      case ROS_1 -> folders.addAll(paths(environment.get("ROS_PACKAGE_PATH")));
      case ROS_2 ->
          paths(environment.get("AMENT_PREFIX_PATH"))
              .forEach(prefix -> folders.add(prefix.resolve("share")));
    }
    return new InterfaceFiles(folders);
  }

  private static List<Path> paths(@Nullable String list) {
    List<Path> paths = new ArrayList<>();
    for (String each : list == null ? new String[0] : list.split(File.pathSeparator)) {
      try {
        if (!each.isBlank()) {
          paths.add(Path.of(each));
        }
      } catch (InvalidPathException e) {
        // What is no path has no files.
        continue;
      }
    }
    return paths;
  }

  /** Where was looked, for people. */
  String describe(Dialect dialect) {
    String variable =
        switch (dialect) {
          case ROS_1 -> "ROS_PACKAGE_PATH";
          case ROS_2 -> "AMENT_PREFIX_PATH";
        };
    return folders.isEmpty()
        ? "the built-in set; " + variable + " names no folder"
        : folders + " and in the built-in set";
  }

  /** The text of a type; null if there is none. */
  @Nullable String find(Dialect dialect, TypeName name) {
    String file = name.kind().folder() + "/" + name.name() + "." + name.kind().folder();
    try {
      for (Path folder : folders) {
        Path found = find(folder, name.pack(), file);
        if (found != null) {
          if (Files.size(found) > MAX_SIZE) {
            throw new DefinitionException(found + " is longer than " + MAX_SIZE + " bytes");
          }
          return new String(Files.readAllBytes(found), StandardCharsets.UTF_8);
        }
      }
      String builtIn = "interfaces/ros" + dialect.version() + "/" + name.pack() + "/" + file;
      try (InputStream in = InterfaceFiles.class.getResourceAsStream(builtIn)) {
        return in == null ? null : new String(in.readAllBytes(), StandardCharsets.UTF_8);
      }
    } catch (IOException e) {
      throw new DefinitionException(name + " cannot be read: " + e.getMessage());
    }
  }

  private static @Nullable Path find(Path folder, String pack, String file) throws IOException {
    Path direct = folder.resolve(pack).resolve(file);
    if (Files.isRegularFile(direct)) {
      return direct;
    }
    Path last = folder.getFileName();
    if (last != null && last.toString().equals(pack) && Files.isRegularFile(folder.resolve(file))) {
      return folder.resolve(file);
    }
    return isSystem(folder) ? null : search(folder, pack, file, MAX_DEPTH);
  }

  /** Whether there are packages in it, but none further down: to look there takes long. */
  private static boolean isSystem(Path folder) {
    return folder.endsWith("share");
  }

  private static @Nullable Path search(Path folder, String pack, String file, int depth)
      throws IOException {
    if (depth == 0 || !Files.isDirectory(folder)) {
      return null;
    }
    List<Path> below;
    try (Stream<Path> all = Files.list(folder)) {
      below = all.filter(each -> !isHidden(each) && Files.isDirectory(each)).sorted().toList();
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    for (Path each : below) {
      if (each.endsWith(pack) && Files.isRegularFile(each.resolve(file))) {
        return each.resolve(file);
      }
      boolean isPackage = Files.exists(each.resolve("package.xml"));
      Path found = isPackage ? null : search(each, pack, file, depth - 1);
      if (found != null) {
        return found;
      }
    }
    return null;
  }

  private static boolean isHidden(Path folder) {
    return String.valueOf(folder.getFileName()).startsWith(".");
  }
}
