package org.urbi.tests.pages;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.urbi.tests.UObjectJars;

/** Compiles the Java of pages: whole classes, and statements, which become those of a class. */
final class JavaListings {
  private static final Pattern CLASS =
      Pattern.compile("^public (?:final )?class (\\w+)", Pattern.MULTILINE);
  private static final String[] FLAGS =
      System.getProperty(
              "urbi.distribution.flags",
              "-XX:+UseSerialGC --add-opens=java.base/java.lang=ALL-UNNAMED")
          .split(" ");

  private static final Pattern OWN_IMPORT = Pattern.compile("^import ", Pattern.MULTILINE);

  /** What pages do not repeat in each listing. */
  private static final String IMPORTS =
      """
      import java.nio.file.*;
      import java.util.*;
      import java.util.concurrent.*;
      import javax.script.*;
      import org.urbi.kernel.*;
      import org.urbi.kernel.embed.*;
      import org.urbi.kernel.script.*;
      import urbi.*;
      """;

  private static final String STATEMENTS =
      """
      public class Statements {
        static void log(Object text) {
          System.out.println(text);
        }

        public static void main(String[] arguments) throws Exception {
      %s
        }
      }
      """;

  private final Path folder;

  /** Uses a folder of its own for what it makes. */
  JavaListings(Path folder) {
    this.folder = folder;
  }

  private record Source(String className, String text) {}

  private static Source source(Listing listing) {
    Matcher named = CLASS.matcher(listing.text());
    String imports = OWN_IMPORT.matcher(listing.text()).find() ? "" : IMPORTS;
    return named.find()
        ? new Source(named.group(1), imports + listing.text())
        : new Source("Statements", imports + STATEMENTS.formatted(listing.text()));
  }

  /** What a file with a listing is called. */
  static String fileName(Listing listing) {
    return source(listing).className() + ".java";
  }

  /** Compiles a listing, and returns where its classes are. */
  Path compile(Listing listing) throws IOException {
    Source source = source(listing);
    Path sources = Files.createTempDirectory(folder, "sources");
    Files.writeString(sources.resolve(fileName(listing)), source.text());
    Path classes = Files.createTempDirectory(folder, "classes");
    UObjectJars.compile(sources, classes);
    return classes;
  }

  /** Makes the module that a listing is named after. */
  void makeModule(Listing listing, Path modules) throws IOException {
    UObjectJars.pack(compile(listing), modules.resolve(listing.detail() + ".jar"), "");
  }

  /** Runs a listing in a process of its own, and returns what it prints. */
  List<String> run(Listing listing) throws IOException {
    Path classes = compile(listing);
    // Surefire hides the class path of the tests in a jar.
    String tests =
        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
    String jars = System.getProperty("urbi.distribution.jars", tests);
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of(FLAGS));
    command.add("-XX:TieredStopAtLevel=1");
    // The jars come first: the start-up cache is for who begins with them.
    command.addAll(List.of("-cp", jars + File.pathSeparator + classes));
    command.add(source(listing).className());
    ProcessBuilder builder = new ProcessBuilder(command);
    Process process = builder.directory(folder.toFile()).redirectErrorStream(true).start();
    process.getOutputStream().close();
    return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
        .lines()
        .toList();
  }
}
