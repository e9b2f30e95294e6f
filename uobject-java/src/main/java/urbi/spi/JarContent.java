package urbi.spi;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipInputStream;
import org.jspecify.annotations.Nullable;

/**
 * The contents of a jar or of a folder of classes, in memory.
 *
 * @param file where it was read
 * @param entries the contents by their names, in the order of the jar
 */
record JarContent(Path file, Map<String, byte[]> entries) {
  private static final String CLASS = ".class";

  static JarContent read(Path file) throws IOException {
    if (Files.isDirectory(file)) {
      return new JarContent(file, readFolder(file));
    }
    byte[] bytes = Files.readAllBytes(file);
    Map<String, byte[]> entries = new LinkedHashMap<>();
    try (var zip = new ZipInputStream(new ByteArrayInputStream(bytes))) {
      ZipEntry entry;
      while ((entry = zip.getNextEntry()) != null) {
        if (!entry.isDirectory()) {
          entries.put(entry.getName(), zip.readAllBytes());
        }
      }
    }
    if (entries.isEmpty()) {
      throw new ZipException("not a jar file");
    }
    return new JarContent(file, entries);
  }

  private static Map<String, byte[]> readFolder(Path folder) throws IOException {
    Map<String, byte[]> entries = new LinkedHashMap<>();
    try (Stream<Path> walk = Files.walk(folder)) {
      for (Path each : walk.filter(Files::isRegularFile).sorted().toList()) {
        String name = folder.relativize(each).toString().replace(File.separatorChar, '/');
        entries.put(name, Files.readAllBytes(each));
      }
    }
    return entries;
  }

  /** What went wrong, in a few words. */
  static String reason(IOException e) {
    return switch (e) {
      case NoSuchFileException none -> "no such file";
      case AccessDeniedException denied -> "permission denied";
      default -> String.valueOf(e.getMessage());
    };
  }

  /** The content of a class, or null. */
  byte @Nullable [] classBytes(String className) {
    return entries.get(className.replace('.', '/') + CLASS);
  }

  /** The names of the classes. */
  Iterable<String> classNames() {
    return entries.keySet().stream()
            .filter(name -> name.endsWith(CLASS) && !name.startsWith("META-INF/"))
            .filter(name -> !name.endsWith("module-info.class"))
            .map(name -> name.substring(0, name.length() - CLASS.length()).replace('/', '.'))
        ::iterator;
  }
}
