package org.urbi.tests.failure;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URI;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** Runs {@code urbi} in an installation where classes are missing. */
final class Programs {
  private Programs() {}

  /**
   * What a run has printed.
   *
   * @param out what the client was told
   * @param log the standard error stream
   */
  record Run(int status, String out, String log) {}

  /** Classes as they are on the class path, but for some. */
  private static final class PartialClassPath extends URLClassLoader {
    private final Set<String> missing;

    PartialClassPath(Set<String> missing) {
      super(classPath(), ClassLoader.getPlatformClassLoader());
      this.missing = missing;
    }

    private static URL[] classPath() {
      return Arrays.stream(System.getProperty("java.class.path").split(":"))
          .map(entry -> Path.of(entry).toUri())
          .map(PartialClassPath::url)
          .toArray(URL[]::new);
    }

    private static URL url(URI place) {
      try {
        return place.toURL();
      } catch (IOException e) {
        throw new IllegalStateException(e);
      }
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
      if (missing.contains(name)) {
        throw new ClassNotFoundException(name);
      }
      return super.findClass(name);
    }
  }

  /** Runs {@code urbi} without these classes on some pieces of source text, each given by -e. */
  static Run without(Set<String> missing, String... pieces) throws Exception {
    return run(missing, Arrays.stream(pieces).flatMap(p -> Stream.of("-e", p)).toList());
  }

  /** Runs {@code urbi} without these classes, with these arguments. */
  static Run run(Set<String> missing, List<String> arguments) throws Exception {
    var out = new ByteArrayOutputStream();
    var log = new ByteArrayOutputStream();
    PrintStream before = System.err;
    try (PartialClassPath loader = new PartialClassPath(missing)) {
      System.setErr(new PrintStream(log, true, StandardCharsets.UTF_8));
      System.setProperty("urbi.root", Path.of("..").toRealPath().toString());
      int status =
          (int)
              loader
                  .loadClass("org.urbi.server.cli.UrbiCommand")
                  .getMethod("run", String[].class, PrintStream.class, PrintStream.class)
                  .invoke(
                      null,
                      Stream.concat(Stream.of("--quiet"), arguments.stream())
                          .toArray(String[]::new),
                      new PrintStream(out, true, StandardCharsets.UTF_8),
                      System.err);
      return new Run(
          status, out.toString(StandardCharsets.UTF_8), log.toString(StandardCharsets.UTF_8));
    } finally {
      System.setErr(before);
    }
  }
}
