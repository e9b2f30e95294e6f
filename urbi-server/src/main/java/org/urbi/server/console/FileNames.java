package org.urbi.server.console;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Completes the names of files in strings that are given to what opens files: {@code
 * load("urbi/comp}, {@code File.new("/tmp/a}.
 */
final class FileNames {
  /** How many entries of a folder are looked at; nobody reads the names of more. */
  private static final int MOST = 5000;

  /** The functions that load scripts, which are looked for in the search path. */
  private static final String LOADING = "load|loadFile|require|requireFile";

  private static final Pattern STRING =
      Pattern.compile(
          "\\b(?:("
              + LOADING
              + ")|(?:File|Directory|Path|OutputStream|InputStream)(?:\\.(?:new|create|save))?)"
              + "\\(\"((?:[^\"\\\\]++|\\\\[\"\\\\])*+)$");

  /** How much before the cursor is looked at; longer names are none. */
  private static final int LONGEST = 1024;

  /** The characters that end a string, move the cursor or are none. */
  private static final Pattern UNWRITABLE = Pattern.compile("[\\p{Cntrl}\uFFFD]");

  private final List<Path> searchPath;

  /**
   * @param searchPath where scripts are looked for
   */
  FileNames(List<Path> searchPath) {
    this.searchPath = searchPath;
  }

  /**
   * The name of a file that is being typed at the end of a text, as it stands in its string; null
   * when there is none.
   */
  static @Nullable String typed(String text) {
    Matcher string = string(text);
    return string.find() ? string.group(2) : null;
  }

  private static Matcher string(String text) {
    return STRING.matcher(text.substring(Math.max(0, text.length() - LONGEST)));
  }

  /** The files that may be meant, as they are written in a string; folders end with a slash. */
  SortedSet<String> of(String text) {
    SortedSet<String> found = new TreeSet<>();
    Matcher string = string(text);
    if (string.find()) {
      String name = string.group(2).replaceAll("\\\\(.)", "$1");
      String folder = name.substring(0, name.lastIndexOf('/') + 1);
      boolean loads = string.group(1) != null;
      for (Path base : loads && !name.startsWith("/") ? searchPath : List.of(Path.of(""))) {
        try {
          addEntries(found, base.resolve(folder), folder, name.substring(folder.length()), loads);
        } catch (IOException | DirectoryIteratorException | InvalidPathException e) {
          // Nothing can be read there.
        }
      }
    }
    return found;
  }

  private static void addEntries(
      SortedSet<String> found, Path directory, String folder, String begun, boolean scripts)
      throws IOException {
    int seen = 0;
    try (DirectoryStream<Path> entries = Files.newDirectoryStream(directory)) {
      for (Path entry : entries) {
        if (++seen > MOST) {
          return;
        }
        String name = entry.getFileName().toString();
        boolean hidden = name.startsWith(".") && !begun.startsWith(".");
        if (name.startsWith(begun) && !hidden && !UNWRITABLE.matcher(name).find()) {
          boolean within = Files.isDirectory(entry);
          if (within || !scripts || name.endsWith(".u")) {
            found.add(written(folder + name) + (within ? "/" : ""));
          }
        }
      }
    }
  }

  private static String written(String name) {
    return name.replace("\\", "\\\\").replace("\"", "\\\"");
  }
}
