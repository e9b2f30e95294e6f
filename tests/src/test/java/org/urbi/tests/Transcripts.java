package org.urbi.tests;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The test resources, found on the class path and sorted by name. */
final class Transcripts {
  private Transcripts() {}

  /** The transcripts of every folder; the key is the folder's path below {@code transcripts}. */
  static SortedMap<String, List<Path>> byFolder() {
    Path root = resource("transcripts");
    return files("transcripts", Transcript.SUFFIX).stream()
        .collect(
            Collectors.groupingBy(
                file -> root.relativize(file.getParent()).toString().replace('\\', '/'),
                TreeMap::new,
                Collectors.toList()));
  }

  /** All files of a resource folder, and below, whose names end so. */
  static List<Path> files(String folder, String suffix) {
    try (Stream<Path> files = Files.walk(resource(folder))) {
      return files.filter(file -> file.toString().endsWith(suffix)).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** What a file is called, as a sentence. */
  static String sentence(Path file) {
    String name = file.getFileName().toString();
    return name.substring(0, name.lastIndexOf('.')).replace('_', ' ');
  }

  private static Path resource(String folder) {
    URL url = Transcripts.class.getResource("/" + folder);
    if (url == null) {
      throw new IllegalStateException("no test resources in " + folder);
    }
    try {
      return Path.of(url.toURI());
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }
}
