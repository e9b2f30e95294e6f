package org.urbi.bench;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Stream;

/**
 * {@code docs/benchmarks.md}, made from {@code bench/benchmarks.md} and what was measured. It
 * carries a digest of the benchmarks, so that it can be told when they have changed since.
 */
final class Document {
  /** What the document says of itself when it has been left behind. */
  static final String OLDER = "These figures are older than the benchmarks";

  /** What the tests of the documentation want to know of each listing. */
  private static final String LISTING = "<!-- listing: not run: figures of one machine -->";

  private static final String MACHINE = "@machine@";
  private static final String TABLES = "@tables@";
  private static final String DIGEST = "<!-- benchmarks %s -->";

  private final Path root;

  Document(Path root) {
    this.root = root;
  }

  /** Where it is. */
  Path file() {
    return root.resolve("docs/benchmarks.md");
  }

  /** Writes it anew. */
  void write(List<String> machine, List<Section> sections) throws IOException {
    var tables = new ByteArrayOutputStream();
    try (var out = new PrintStream(tables, false, StandardCharsets.UTF_8)) {
      for (Section section : sections) {
        out.println("## " + section.title() + "\n\n" + LISTING + "\n```");
        new Table(section.results()).print(out);
        out.println("```\n");
      }
    }
    String text =
        Files.readString(template())
            .replace(MACHINE, String.join(", ", machine))
            .replace(TABLES, tables.toString(StandardCharsets.UTF_8).strip());
    Files.writeString(file(), text + "\n" + DIGEST.formatted(digest()) + "\n");
  }

  /** Whether it was made by the benchmarks that are there now, or else says that it was not. */
  boolean isHonest() throws IOException {
    String text = Files.readString(file());
    return text.contains(DIGEST.formatted(digest())) || text.contains(OLDER);
  }

  /** What is different when a program, the choice of programs or the text has changed. */
  String digest() throws IOException {
    try {
      var digest = MessageDigest.getInstance("SHA-256");
      for (Path file : sources()) {
        digest.update(root.relativize(file).toString().getBytes(StandardCharsets.UTF_8));
        digest.update(Files.readAllBytes(file));
      }
      return HexFormat.of().formatHex(digest.digest(), 0, 8);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  private List<Path> sources() throws IOException {
    Stream.Builder<Path> files = Stream.builder();
    files.add(template());
    files.add(root.resolve("bench/src/main/java/org/urbi/bench/Row.java"));
    for (String folder : Installation.FOLDERS) {
      try (Stream<Path> programs = Files.walk(root.resolve("bench").resolve(folder))) {
        programs.filter(Files::isRegularFile).forEach(files);
      }
    }
    return files.build().sorted().toList();
  }

  private Path template() {
    return root.resolve("bench/benchmarks.md");
  }
}
