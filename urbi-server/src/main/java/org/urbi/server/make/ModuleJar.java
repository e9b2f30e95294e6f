package org.urbi.server.make;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.classfile.ClassFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.Enumeration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.Manifest;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.urbi.server.options.Failure;
import urbi.spi.ModuleIndex;

/**
 * Writes the jar of a module. The same classes always give the same bytes. If a name is added
 * twice, the first entry counts.
 */
final class ModuleJar {
  /** The earliest time that a jar can express. */
  private static final LocalDateTime LONG_AGO = LocalDateTime.of(1980, 1, 1, 0, 0);

  private static final String CLASS = ".class";
  private static final String META = "META-INF/";

  private final SortedMap<String, byte[]> entries = new TreeMap<>();

  /** The folders in which packages of classes begin. */
  private final Set<Path> roots = new LinkedHashSet<>();

  /** Adds classes by their names in a jar. */
  void add(Map<String, byte[]> classes) {
    classes.forEach(entries::putIfAbsent);
  }

  /** Adds a class file, in any folder. */
  void addClass(Path file) {
    try {
      byte[] bytes = Files.readAllBytes(file);
      String name = ClassFile.of().parse(bytes).thisClass().asInternalName();
      entries.putIfAbsent(name + CLASS, bytes);
      addRoot(file.toAbsolutePath().normalize(), Path.of(name + CLASS));
    } catch (IOException e) {
      throw Failure.of("cannot read " + file + ": " + e.getMessage());
    } catch (IllegalArgumentException e) {
      throw Failure.of("not a class file: " + file);
    }
  }

  private void addRoot(Path file, Path place) {
    int above = file.getNameCount() - place.getNameCount();
    if (above > 0 && file.endsWith(place)) {
      roots.add(file.getRoot().resolve(file.subpath(0, above)));
    }
  }

  /** Adds the contents of another jar, without its manifest and signatures. */
  void addLibrary(Path file) {
    try (ZipFile zip = new ZipFile(file.toFile())) {
      if (zip.getEntry("urbi/UObject.class") != null) {
        // The kernel provides the package urbi; the module must not have a second copy.
        return;
      }
      for (Enumeration<? extends ZipEntry> all = zip.entries(); all.hasMoreElements(); ) {
        ZipEntry entry = all.nextElement();
        if (!entry.isDirectory() && !entry.getName().startsWith(META)) {
          entries.putIfAbsent(entry.getName(), zip.getInputStream(entry).readAllBytes());
        }
      }
    } catch (IOException e) {
      throw Failure.of("cannot read " + file + ": " + e.getMessage());
    }
  }

  /**
   * Adds the files that the classes may read as resources: those in the folders of the classes
   * added so far. A folder with sources is somebody's workplace, of which only classes are taken.
   */
  void addResources(Set<Path> files, Set<Path> sources) {
    for (Path root : roots) {
      if (sources.stream().noneMatch(source -> isIn(root, source))) {
        files.stream().filter(file -> isIn(root, file)).forEach(file -> addResource(root, file));
      }
    }
  }

  private static boolean isIn(Path folder, Path file) {
    return file.toAbsolutePath().normalize().startsWith(folder);
  }

  private void addResource(Path root, Path file) {
    String name = root.relativize(file.toAbsolutePath().normalize()).toString();
    String entry = name.replace(File.separatorChar, '/');
    if (!entry.startsWith(META)) {
      try {
        entries.putIfAbsent(entry, Files.readAllBytes(file));
      } catch (IOException e) {
        throw Failure.of("cannot read " + file + ": " + e.getMessage());
      }
    }
  }

  /** The number of classes. */
  int classCount() {
    return (int) entries.keySet().stream().filter(name -> name.endsWith(CLASS)).count();
  }

  /** The names of the classes that declare UObjects. */
  List<String> uobjects() {
    List<String> names = new ArrayList<>();
    entries.forEach((name, bytes) -> {
      if (name.endsWith(CLASS) && !name.startsWith("urbi/") && ModuleIndex.declares(bytes)) {
        names.add(name.substring(0, name.length() - CLASS.length()).replace('/', '.'));
      }
    });
    return names;
  }

  /** Writes the jar atomically, so that a program that watches the file never sees half of it. */
  void write(Path file) {
    try {
      Path folder = file.toAbsolutePath().getParent();
      Path part = Files.createTempFile(folder, file.getFileName().toString(), ".part");
      try {
        try (OutputStream out = Files.newOutputStream(part)) {
          write(out);
        }
        part.toFile().setReadable(true, false);
        Files.move(part, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
      } finally {
        Files.deleteIfExists(part);
      }
    } catch (IOException e) {
      throw Failure.of("cannot write " + file + ": " + e);
    }
  }

  private void write(OutputStream out) throws IOException {
    try (ZipOutputStream zip = new ZipOutputStream(out)) {
      ByteArrayOutputStream manifest = new ByteArrayOutputStream();
      manifest().write(manifest);
      write(zip, META + "MANIFEST.MF", manifest.toByteArray());
      for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
        write(zip, entry.getKey(), entry.getValue());
      }
    }
  }

  private static void write(ZipOutputStream zip, String name, byte[] bytes) throws IOException {
    ZipEntry entry = new ZipEntry(name);
    entry.setTimeLocal(LONG_AGO);
    zip.putNextEntry(entry);
    zip.write(bytes);
    zip.closeEntry();
  }

  private Manifest manifest() {
    Manifest manifest = new Manifest();
    Attributes attributes = manifest.getMainAttributes();
    attributes.put(Attributes.Name.MANIFEST_VERSION, "1.0");
    attributes.putValue("Created-By", "umake-java");
    attributes.putValue(ModuleIndex.ATTRIBUTE, String.join(" ", uobjects()));
    return manifest;
  }
}
