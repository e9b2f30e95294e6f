package org.urbi.server.make;

import static java.util.Objects.requireNonNull;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import javax.tools.Diagnostic;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.urbi.server.options.Failure;
import urbi.UObject;

/** Compiles Java sources with the JDK's compiler, in memory. */
final class SourceCompiler {
  private final JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
  private final PrintStream err;
  private final boolean warnings;

  /**
   * @param err where the compiler's complaints go
   * @param warnings whether to complain of what is not an error
   */
  SourceCompiler(PrintStream err, boolean warnings) {
    if (compiler == null) {
      throw Failure.of(
          "compiling takes a JDK, and the Java in "
              + System.getProperty("java.home")
              + " is a runtime only; URBI_JAVA_HOME names the one to use");
    }
    this.err = err;
    this.warnings = warnings;
  }

  /**
   * The jar or folder from which this program has the package {@code urbi}. Classes that come from
   * a start-up cache do not know it in a folder whose name is not ASCII: the loader does.
   */
  static Path api() {
    String file = UObject.class.getName().replace('.', '/') + ".class";
    URL found = UObject.class.getClassLoader().getResource(file);
    try {
      if (requireNonNull(found, "it is loaded").openConnection() instanceof JarURLConnection jar) {
        return Path.of(jar.getJarFileURL().toURI());
      }
      return Path.of(found.toURI().resolve(".."));
    } catch (IOException | URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  /** The options that the compiler is given. */
  static List<String> options(List<Path> classPath, List<Path> sourcePath, List<String> extra) {
    List<String> options = new ArrayList<>(List.of("-proc:none", "-g"));
    List<Path> classes = new ArrayList<>(classPath);
    classes.add(api());
    options.addAll(List.of("-classpath", joined(classes)));
    // Without a source path the compiler would look for sources among the classes.
    options.addAll(List.of("-sourcepath", joined(sourcePath)));
    options.addAll(extra);
    return options;
  }

  private static String joined(List<Path> paths) {
    return paths.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
  }

  /**
   * Compiles.
   *
   * @return the class files by their names in a jar
   * @throws Failure if there are errors, which have been shown
   */
  SortedMap<String, byte[]> compile(Collection<Path> sources, List<String> options) {
    List<Diagnostic<? extends JavaFileObject>> errors = new ArrayList<>();
    try (StandardJavaFileManager files =
            compiler.getStandardFileManager(null, Locale.ROOT, StandardCharsets.UTF_8);
        MemoryFiles memory = new MemoryFiles(files)) {
      JavaCompiler.CompilationTask task =
          compiler.getTask(
              new PrintWriter(err, true, StandardCharsets.UTF_8),
              memory,
              diagnostic -> show(diagnostic, errors),
              options,
              null,
              files.getJavaFileObjectsFromPaths(sources));
      if (!task.call()) {
        int count = Math.max(1, errors.size());
        throw Failure.of("compilation failed: " + UmakeJava.count(count, "error"));
      }
      return memory.classes();
    } catch (IOException e) {
      throw Failure.of("compilation failed: " + e.getMessage());
    } catch (IllegalArgumentException e) {
      throw Failure.usage("invalid option for the compiler: " + e.getMessage());
    }
  }

  private void show(
      Diagnostic<? extends JavaFileObject> diagnostic,
      List<Diagnostic<? extends JavaFileObject>> errors) {
    boolean isError = diagnostic.getKind() == Diagnostic.Kind.ERROR;
    if (isError) {
      errors.add(diagnostic);
    }
    if (isError || warnings) {
      err.println(diagnostic);
    }
  }

  /** Keeps the compiled classes in memory. */
  private static final class MemoryFiles extends ForwardingJavaFileManager<JavaFileManager> {
    private final SortedMap<String, ByteArrayOutputStream> written = new TreeMap<>();

    MemoryFiles(JavaFileManager files) {
      super(files);
    }

    @Override
    public JavaFileObject getJavaFileForOutput(
        Location location, String className, JavaFileObject.Kind kind, FileObject sibling) {
      String name = className.replace('.', '/') + kind.extension;
      return new SimpleJavaFileObject(URI.create("memory:/" + name), kind) {
        @Override
        public OutputStream openOutputStream() {
          ByteArrayOutputStream bytes = new ByteArrayOutputStream();
          written.put(name, bytes);
          return bytes;
        }
      };
    }

    SortedMap<String, byte[]> classes() {
      SortedMap<String, byte[]> classes = new TreeMap<>();
      written.forEach((name, bytes) -> classes.put(name, bytes.toByteArray()));
      return classes;
    }
  }
}
