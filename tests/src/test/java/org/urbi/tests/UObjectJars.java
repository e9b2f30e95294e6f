package org.urbi.tests;

import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
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

  /** Made once, for all tests. */
  private static final class Made {
    static final Path FOLDER = makeAll();

    private static Path makeAll() {
      try (Stream<Path> modules = Files.list(SOURCES)) {
        // Of this JVM alone: others run other tests at the same time.
        Path folder = Files.createTempDirectory(Path.of("target"), "uobject-jars").toAbsolutePath();
        for (Path module : modules.sorted().toList()) {
          make(module, folder.resolve(module.getFileName() + ".jar"));
        }
        return folder;
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  /** The folder with all the jars. */
  static Path folder() {
    return Made.FOLDER;
  }

  /** Compiles all the sources in a folder, and puts the classes in a jar. */
  static void make(Path sources, Path jar) throws IOException {
    try (Stream<Path> files = Files.walk(sources)) {
      make(files.filter(file -> file.toString().endsWith(".java")).sorted().toList(), jar);
    }
  }

  /** Compiles a source of that name, and puts the classes in a jar. */
  static void make(String className, String source, Path jar) throws IOException {
    Path folder = Files.createTempDirectory("uobject-source");
    Path file = folder.resolve(className + ".java");
    Files.writeString(file, source);
    make(List.of(file), jar);
  }

  private static void make(List<Path> sources, Path jar) throws IOException {
    Path classes = Files.createTempDirectory("uobject-classes");
    compile(sources, classes);
    pack(classes, jar, "");
  }

  /** Compiles all the sources in a folder to another one. */
  public static void compile(Path sources, Path classes) throws IOException {
    try (Stream<Path> files = Files.walk(sources)) {
      compile(files.filter(file -> file.toString().endsWith(".java")).sorted().toList(), classes);
    }
  }

  private static void compile(List<Path> sources, Path classes) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter messages = new StringWriter();
    try (StandardJavaFileManager files =
        compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
      boolean compiled =
          compiler
              .getTask(
                  messages,
                  files,
                  null,
                  List.of("-d", classes.toString(), "-proc:none"),
                  null,
                  files.getJavaFileObjectsFromPaths(sources))
              .call();
      if (!compiled) {
        throw new IllegalStateException(messages.toString());
      }
    }
  }

  /** Packs a folder of classes, but for those whose name begins with a given one. */
  public static void pack(Path classes, Path jar, String without) throws IOException {
    List<Path> files = new ArrayList<>();
    try (Stream<Path> all = Files.walk(classes)) {
      all.filter(Files::isRegularFile).sorted().forEach(files::add);
    }
    Path part = jar.resolveSibling(jar.getFileName() + ".part");
    try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(part))) {
      for (Path file : files) {
        String name = classes.relativize(file).toString().replace('\\', '/');
        if (without.isEmpty() || !name.startsWith(without)) {
          out.putNextEntry(new JarEntry(name));
          Files.copy(file, out);
          out.closeEntry();
        }
      }
    }
    Files.move(part, jar, StandardCopyOption.REPLACE_EXISTING);
  }
}
