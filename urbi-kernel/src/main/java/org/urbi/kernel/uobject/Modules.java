package org.urbi.kernel.uobject;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.outside.ConfinedException;
import org.urbi.kernel.outside.Disk;
import org.urbi.kernel.outside.Outside;
import urbi.UClass;
import urbi.UHubClass;
import urbi.UModule;
import urbi.UModuleException;
import urbi.spi.ModuleFiles;

/**
 * The modules that are loaded: jars and libraries with UObjects (manual, "System", loadModule). A
 * module that is loaded again is replaced if its file has changed: its urbiscript objects stay.
 */
public final class Modules {
  /** The state of a file, by which it is seen whether it has changed. */
  private record FileState(long modified, long size) {}

  /** A module, with the state of its file when it was loaded. */
  private record Loaded(UModule module, FileState state) {}

  /** A module in a process of its own, with the state of its file when it was loaded. */
  private record LoadedApart(ModuleIsolation.IsolatedModule module, FileState state) {}

  private final PluggedContext context;
  private final List<Path> searchPath;
  private final Outside outside;
  private final Map<Path, Loaded> loaded = new LinkedHashMap<>();
  private final Map<Path, LoadedApart> isolated = new LinkedHashMap<>();
  private @Nullable ModuleIsolation isolation;

  /** The modules whose classes all the others can use. */
  private final List<UModule> libraries = new CopyOnWriteArrayList<>();

  Modules(PluggedContext context, List<Path> searchPath, Outside outside) {
    this.context = context;
    this.searchPath = List.copyOf(searchPath);
    this.outside = outside;
  }

  /** The folders in which modules are searched, in order. */
  public List<Path> searchPath() {
    return searchPath;
  }

  /** Sets who runs modules in processes of their own; before the first one is loaded. */
  public void setIsolation(ModuleIsolation how) {
    isolation = how;
  }

  /** The names of the files that are loaded, in the order in which they were. */
  public List<Path> files() {
    List<Path> files = new ArrayList<>(loaded.keySet());
    isolated.forEach((file, each) -> {
      if (each.module.isRunning()) {
        files.add(file);
      }
    });
    return files;
  }

  /**
   * The file of a module: a path, or a name that is looked for in the search path; the suffix may
   * be left out.
   *
   * @param working the directory from which relative paths start
   * @return null if there is none
   */
  public @Nullable Path find(Path working, String name) {
    for (String suffix : suffixes(name)) {
      try {
        Path path = Path.of(name + suffix);
        List<Path> folders = new ArrayList<>();
        if (!path.isAbsolute()) {
          searchPath.forEach(folder -> folders.add(working.resolve(folder)));
        }
        folders.add(working);
        for (Path folder : folders) {
          Path candidate = folder.resolve(path).normalize();
          if (disk().isRegularFile(candidate)) {
            return candidate;
          }
        }
      } catch (InvalidPathException | IOException e) {
        return null;
      }
    }
    return null;
  }

  /** The suffixes that may be left out. */
  private static List<String> suffixes(String name) {
    List<String> suffixes = new ArrayList<>(List.of(""));
    List<String> known = ModuleFiles.suffixes();
    if (known.stream().noneMatch(name::endsWith)) {
      suffixes.addAll(known);
    }
    return suffixes;
  }

  /**
   * Loads a module; does nothing if that very file is loaded already. One that runs in a process of
   * its own keeps to that.
   *
   * @param library whether its classes can be used by all modules; it need not have UObjects then
   * @throws UModuleException if the file is no module, or modules are not allowed
   * @throws org.urbi.kernel.error.UrbiException if a constructor fails
   */
  public void load(Frame frame, Path file, boolean library) {
    find(
        file,
        (key, state) -> {
          if (isIsolated(key)) {
            isolate(frame, key, state);
          } else {
            load(frame, key, state, library);
          }
        });
  }

  private void load(Frame frame, Path key, FileState state, boolean library) {
    Loaded before = loaded.get(key);
    if (before != null && before.state.equals(state)) {
      return;
    }
    UModule module = read(frame, key, library);
    start(frame, module, before);
    loaded.put(key, new Loaded(module, state));
    if (before != null) {
      libraries.remove(before.module);
    }
    if (library) {
      libraries.add(module);
    }
  }

  /**
   * Runs a module in a process of its own; does nothing if that very file is running so already.
   *
   * @throws UModuleException if that fails, or is not allowed
   */
  public void isolate(Frame frame, Path file) {
    find(file, (key, state) -> isolate(frame, key, state));
  }

  private void isolate(Frame frame, Path key, FileState state) {
    LoadedApart before = isolated.get(key);
    if (before == null || !before.module.isRunning() || !before.state.equals(state)) {
      unload(frame, key);
      before = new LoadedApart(requireNonNull(isolation).start(frame, key), state);
      isolated.put(key, before);
    }
    before.module.awaitStart();
  }

  /** Looks at the file of a module, if modules are allowed, and does something with it. */
  private void find(Path file, BiConsumer<Path, FileState> found) {
    try {
      outside.confinement().checkModules();
      Path key = disk().real(file);
      found.accept(key, new FileState(disk().lastModified(key), disk().size(key)));
    } catch (ConfinedException e) {
      throw new UModuleException(e.getMessage(), e);
    } catch (IOException e) {
      throw new UModuleException(
          Problem.UNREADABLE_MODULE.text(file, String.valueOf(e.getMessage())), e);
    }
  }

  private boolean isIsolated(Path key) {
    LoadedApart module = isolated.get(key);
    return module != null && module.module.isRunning();
  }

  private UModule read(Frame frame, Path file, boolean library) {
    Frame outer = context.crossing().leave(frame, file.toString());
    try {
      return library ? ModuleFiles.loadLibrary(file, libraries) : ModuleFiles.load(file, libraries);
    } finally {
      context.crossing().back(frame, outer);
    }
  }

  private void start(Frame frame, UModule module, @Nullable Loaded before) {
    try {
      module.startIn(context);
    } catch (RuntimeException | Error e) {
      if (before == null) {
        end(frame, module);
      } else {
        module.leave(context);
      }
      throw e;
    }
    if (before != null) {
      endRest(frame, before.module, module);
      before.module.leave(context);
    }
  }

  /** Ends the classes that the new version of a module no longer has. */
  private void endRest(Frame frame, UModule old, UModule present) {
    for (UClass type : old.classes()) {
      if (present.classes().stream().noneMatch(other -> other.name().equals(type.name()))) {
        context.creation().endClass(frame, type);
      }
    }
    for (UHubClass hub : old.hubs()) {
      if (present.hubs().stream().noneMatch(other -> other.name().equals(hub.name()))) {
        context.endHub(hub.name());
      }
    }
  }

  private void end(Frame frame, UModule module) {
    module.leave(context);
    module.classes().forEach(type -> context.creation().endClass(frame, type));
    module.hubs().forEach(hub -> context.endHub(hub.name()));
  }

  /**
   * Unloads a module: its objects stay in urbiscript without what was bound.
   *
   * @return false if it is not loaded
   */
  public boolean unload(Frame frame, Path file) {
    Path key = key(file);
    boolean apart = isIsolated(key);
    LoadedApart process = isolated.remove(key);
    if (apart) {
      process.module.end();
    }
    Loaded module = loaded.remove(key);
    if (module == null) {
      return apart;
    }
    libraries.remove(module.module);
    end(frame, module.module);
    return true;
  }

  /** Starts a module that does not come from a file, such as the classes of the program itself. */
  public void start(Frame frame, UModule module) {
    start(frame, module, null);
  }

  private Path key(Path file) {
    try {
      return disk().real(file);
    } catch (IOException e) {
      return file.toAbsolutePath().normalize();
    }
  }

  private Disk disk() {
    return outside.disk();
  }

  /** The kernel has ended. */
  void close() {
    loaded.values().forEach(each -> each.module.leave(context));
  }
}
