package org.urbi.ros.uobject;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/** The module as urbi loads it: a jar of the classes under test. */
final class RosJar {
  private RosJar() {}

  /** Writes {@code urbi/ros.jar} into a folder. */
  static void writeTo(Path folder) throws IOException {
    Path classes = Path.of("target", "classes");
    Path file = Files.createDirectories(folder.resolve("urbi")).resolve("ros.jar");
    try (OutputStream out = Files.newOutputStream(file);
        ZipOutputStream jar = new ZipOutputStream(out);
        Stream<Path> all = Files.walk(classes)) {
      List<Path> files = all.filter(Files::isRegularFile).sorted().toList();
      for (Path each : files) {
        jar.putNextEntry(new ZipEntry(classes.relativize(each).toString().replace('\\', '/')));
        Files.copy(each, jar);
        jar.closeEntry();
      }
    }
  }
}
