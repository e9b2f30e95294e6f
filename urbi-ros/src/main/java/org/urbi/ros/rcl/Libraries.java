package org.urbi.ros.rcl;

import java.io.IOException;
import java.lang.foreign.Linker;
import java.lang.foreign.MemorySegment;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.urbi.ros.graph.RosException;

/**
 * The libraries of an installation. What they need is looked for beside them, too, whether {@code
 * LD_LIBRARY_PATH} says so or not.
 */
final class Libraries {
  private static final int LAZY = 1;
  private static final String MISSING = ": cannot open shared object file";

  /** The functions of the libraries of the system. */
  private static final CFunctions SYSTEM =
      new CFunctions(
          name -> Linker.nativeLinker().defaultLookup().find(name).orElse(MemorySegment.NULL));

  private final List<Path> folders;
  private final List<MemorySegment> open = new CopyOnWriteArrayList<>();
  private final Set<String> names = new HashSet<>();

  /**
   * @param folders where they are, the first one first
   */
  Libraries(List<Path> folders) {
    this.folders = folders;
  }

  /** Where a function is; {@link MemorySegment#NULL} if it is in none that is loaded. */
  MemorySegment find(String function) {
    for (MemorySegment each : open) {
      MemorySegment found = SYSTEM.pointer("dlsym", each, function);
      if (!found.equals(MemorySegment.NULL)) return found;
    }
    return MemorySegment.NULL;
  }

  /**
   * Loads a library, if it was not loaded yet.
   *
   * @throws RosException if it is not there, or needs what is not there
   */
  synchronized void load(String name) {
    if (names.contains(name)) return;
    Path file =
        fileOf(name).orElseThrow(() -> new RosException("there is no " + name + " in " + folders));
    Set<String> tried = new HashSet<>();
    while (true) {
      // To find a function forgets what was wrong: this one is found before.
      lastError();
      MemorySegment handle = SYSTEM.pointer("dlopen", file.toString(), LAZY);
      if (!handle.equals(MemorySegment.NULL)) {
        names.add(name);
        open.add(handle);
        return;
      }
      String reason = lastError();
      int end = reason.indexOf(MISSING);
      String needed = end < 0 ? "" : reason.substring(0, end);
      if (!tried.add(needed) || fileOf(needed).isEmpty())
        throw new RosException(file + " cannot be loaded: " + reason);
      load(needed);
    }
  }

  private static String lastError() {
    return CFunctions.text(SYSTEM.pointer("dlerror"));
  }

  /** Loads all libraries of a folder whose names begin and end so. */
  void loadAll(String begin, String end) {
    for (Path folder : folders) {
      if (!Files.isDirectory(folder)) continue;
      try (DirectoryStream<Path> all = Files.newDirectoryStream(folder, begin + "*" + end)) {
        for (Path each : all) load(each.getFileName().toString());
      } catch (IOException e) {
        throw new RosException(folder + " cannot be read: " + e.getMessage(), e);
      }
    }
  }

  private Optional<Path> fileOf(String name) {
    if (name.isEmpty() || name.contains("/")) return Optional.empty();
    return folders.stream().map(each -> each.resolve(name)).filter(Files::exists).findFirst();
  }

  /** Sets a variable of the environment of C, unless it is there. */
  static void environment(String name, String value) {
    SYSTEM.number("setenv", name, value, 0);
  }
}
