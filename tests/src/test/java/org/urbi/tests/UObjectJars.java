package org.urbi.tests;

import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * Modules with UObjects, compiled from the folders of {@code src/test/resources/uobjects}: one jar
 * for each, of the same name.
 */
public final class UObjectJars {
  private static final Path SOURCES = Path.of("src", "test", "resources", "uobjects");

  private UObjectJars() {}

  /** What this JVM makes: others run other tests at the same time. It goes when the JVM ends. */
  private static final class Own {
    static final Path FOLDER = make();

    private static Path make() {
      try {
        Path folder = Files.createTempDirectory(Path.of("target"), "uobject-jars").toAbsolutePath();
        Runtime.getRuntime().addShutdownHook(new Thread(() -> delete(folder)));
        return folder;
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }

    private static void delete(Path folder) {
      try (Stream<Path> all = Files.walk(folder)) {
        all.sorted(Comparator.reverseOrder()).map(Path::toFile).forEach(File::delete);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  /** Made once, for all tests. */
  private static final class Made {
    static final Path FOLDER = makeAll();

    private static Path makeAll() {
      try (Stream<Path> modules = Files.list(SOURCES)) {
        Path folder = Files.createDirectory(Own.FOLDER.resolve("jars"));
        // All at once, so that the compiler reads only once what each of them needs.
        Path classes = Files.createTempDirectory(Own.FOLDER, "classes");
        compile(SOURCES, classes);
        for (Path module : modules.sorted().toList()) {
          Set<String> own = classNames(module);
          Path jar = folder.resolve(module.getFileName() + ".jar");
          pack(classes, jar, name -> own.contains(name.replaceFirst("[$.].*", "")));
        }
        return folder;
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  /** The jars of the class path stay open: to read them again takes as long as to compile. */
  private static final class Compiler {
    static final JavaCompiler JAVAC = ToolProvider.getSystemJavaCompiler();
    static final StandardJavaFileManager FILES =
        JAVAC.getStandardFileManager(null, null, StandardCharsets.UTF_8);
  }

  /** The folder with all the jars. */
  static Path folder() {
    return Made.FOLDER;
  }

  private static List<Path> sources(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(file -> file.toString().endsWith(".java")).sorted().toList();
    }
  }

  /** Those of the sources in a folder, each of which has one class. */
  private static Set<String> classNames(Path folder) throws IOException {
    return sources(folder).stream()
        .map(file -> file.getFileName().toString().replace(".java", ""))
        .collect(Collectors.toSet());
  }

  /** Compiles a source of that name, and puts the classes in a jar. */
  static void make(String className, String source, Path jar) throws IOException {
    Path folder = Files.createTempDirectory(Own.FOLDER, "source");
    Path file = folder.resolve(className + ".java");
    Files.writeString(file, source);
    Path classes = Files.createTempDirectory(Own.FOLDER, "classes");
    compile(folder, classes);
    pack(classes, jar, "");
  }

  /** Compiles all the sources in a folder to another one. */
  public static synchronized void compile(Path sources, Path classes) throws IOException {
    StringWriter messages = new StringWriter();
    boolean compiled =
        Compiler.JAVAC
            .getTask(
                messages,
                Compiler.FILES,
                null,
                List.of("-d", classes.toString(), "-proc:none"),
                null,
                Compiler.FILES.getJavaFileObjectsFromPaths(sources(sources)))
            .call();
    if (!compiled) {
      throw new IllegalStateException(messages.toString());
    }
  }

  /** Packs a folder of classes, but for those whose name begins with a given one. */
  public static void pack(Path classes, Path jar, String without) throws IOException {
    pack(classes, jar, name -> without.isEmpty() || !name.startsWith(without));
  }

  private static void pack(Path classes, Path jar, Predicate<String> packed) throws IOException {
    List<Path> files = new ArrayList<>();
    try (Stream<Path> all = Files.walk(classes)) {
      all.filter(Files::isRegularFile).sorted().forEach(files::add);
    }
    Path part = jar.resolveSibling(jar.getFileName() + ".part");
    try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(part))) {
      for (Path file : files) {
        String name = classes.relativize(file).toString().replace('\\', '/');
        if (packed.test(name)) {
          out.putNextEntry(new JarEntry(name));
          Files.copy(file, out);
          out.closeEntry();
        }
      }
    }
    Files.move(part, jar, StandardCopyOption.REPLACE_EXISTING);
  }
}
