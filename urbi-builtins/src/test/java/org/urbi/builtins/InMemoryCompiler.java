package org.urbi.builtins;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.StringWriter;
import java.io.Writer;
import java.net.URI;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** Compiles sources with the processor, without touching the disk. */
final class InMemoryCompiler {
  /** What came out: the errors as {@code line: message}, the sources and classes generated. */
  record Output(List<String> errors, Map<String, String> sources, Map<String, byte[]> classes) {
    /** Loads the classes. */
    ClassLoader loader() {
      return new ClassLoader(InMemoryCompiler.class.getClassLoader()) {
        @Override
        protected Class<?> findClass(String name) throws ClassNotFoundException {
          byte[] bytes = classes.get(name);
          if (bytes == null) {
            throw new ClassNotFoundException(name);
          }
          return defineClass(name, bytes, 0, bytes.length);
        }
      };
    }
  }

  private InMemoryCompiler() {}

  /** Compiles sources, given by the qualified names of their classes. */
  static Output compile(Map<String, String> sources, String... options) {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    DiagnosticCollector<JavaFileObject> diagnostics = new DiagnosticCollector<>();
    Map<String, StringWriter> generated = new LinkedHashMap<>();
    Map<String, ByteArrayOutputStream> classes = new LinkedHashMap<>();
    StandardJavaFileManager standard =
        compiler.getStandardFileManager(diagnostics, Locale.ROOT, null);
    JavaFileManager files = new Files(standard, generated, classes);
    List<JavaFileObject> units = new ArrayList<>();
    sources.forEach((name, text) -> units.add(new Text(name, text)));
    JavaCompiler.CompilationTask task =
        compiler.getTask(null, files, diagnostics, List.of(options), null, units);
    task.setProcessors(List.of(new BuiltinProcessor()));
    task.call();
    Map<String, String> generatedTexts = new LinkedHashMap<>();
    generated.forEach((name, writer) -> generatedTexts.put(name, writer.toString()));
    Map<String, byte[]> bytes = new LinkedHashMap<>();
    classes.forEach((name, stream) -> bytes.put(name, stream.toByteArray()));
    List<String> errors =
        diagnostics.getDiagnostics().stream()
            .filter(d -> d.getKind() == Diagnostic.Kind.ERROR)
            .map(d -> d.getLineNumber() + ": " + d.getMessage(Locale.ROOT))
            .toList();
    return new Output(errors, generatedTexts, bytes);
  }

  private static URI uri(String name, JavaFileObject.Kind kind) {
    return URI.create("string:///" + name.replace('.', '/') + kind.extension);
  }

  private static final class Text extends SimpleJavaFileObject {
    private final String text;

    Text(String name, String text) {
      super(uri(name, Kind.SOURCE), Kind.SOURCE);
      this.text = text;
    }

    @Override
    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
      return text;
    }
  }

  private static final class Files extends ForwardingJavaFileManager<JavaFileManager> {
    private final Map<String, StringWriter> sources;
    private final Map<String, ByteArrayOutputStream> classes;

    Files(
        JavaFileManager parent,
        Map<String, StringWriter> sources,
        Map<String, ByteArrayOutputStream> classes) {
      super(parent);
      this.sources = sources;
      this.classes = classes;
    }

    @Override
    public JavaFileObject getJavaFileForOutput(
        Location location, String name, JavaFileObject.Kind kind, FileObject sibling) {
      return new SimpleJavaFileObject(uri(name, kind), kind) {
        @Override
        public Writer openWriter() {
          return sources.computeIfAbsent(name, n -> new StringWriter());
        }

        @Override
        public CharSequence getCharContent(boolean ignoreEncodingErrors) {
          return sources.get(name).toString();
        }

        @Override
        public OutputStream openOutputStream() {
          return classes.computeIfAbsent(name, n -> new ByteArrayOutputStream());
        }
      };
    }
  }
}
