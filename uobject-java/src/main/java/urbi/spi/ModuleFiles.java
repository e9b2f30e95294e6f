package urbi.spi;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import urbi.UModule;
import urbi.UModuleException;
import urbi.UObject;
import urbi.UStart;

/**
 * Loads modules from files: jars and folders of classes itself, others by a {@link ModuleLoader}.
 *
 * <p>A jar is read whole when it is loaded, into a class loader of its own; the file may be
 * replaced at any time. Two contexts that load the same jar share nothing.
 */
public final class ModuleFiles {
  private ModuleFiles() {}

  /** What loads modules that are not jars. */
  private static ServiceLoader<ModuleLoader> loaders() {
    return ServiceLoader.load(ModuleLoader.class, ModuleFiles.class.getClassLoader());
  }

  /** What the names of files with modules end with, with the dot; those of jars come first. */
  public static List<String> suffixes() {
    List<String> suffixes = new ArrayList<>(List.of(".jar"));
    loaders().forEach(other -> suffixes.add(other.suffix()));
    return suffixes;
  }

  /**
   * Loads a jar, or a folder of classes: every class in it that calls {@link UObject#UStart} or
   * {@link UObject#UStartHub} when it is initialized, or is annotated with {@link UStart}, is
   * initialized now; which these are {@linkplain ModuleIndex the manifest} may say. Files that end
   * as a {@link ModuleLoader} wants it are loaded by that.
   *
   * @throws UModuleException if the file cannot be read or is no jar, has no such class, or one
   *     that cannot be loaded
   */
  public static UModule load(Path jar) {
    return load(jar, List.of());
  }

  /**
   * Loads a jar that may use classes of other ones, too.
   *
   * @param libraries looked into for classes that the jar lacks, whenever one is needed
   * @throws UModuleException as {@link #load(Path)}
   */
  public static UModule load(Path jar, List<UModule> libraries) {
    UModule module = loadLibrary(jar, libraries);
    if (module.classes().isEmpty() && module.hubs().isEmpty()) {
      throw new UModuleException("no UObject in " + jar);
    }
    return module;
  }

  /**
   * Loads a jar for the classes in it, which may be UObjects.
   *
   * @throws UModuleException as {@link #load(Path)}, but it need not have UObjects
   */
  public static UModule loadLibrary(Path jar, List<UModule> libraries) {
    for (ModuleLoader other : loaders()) {
      if (jar.toString().endsWith(other.suffix())) {
        return other.load(jar);
      }
    }
    JarContent content;
    try {
      content = JarContent.read(jar);
    } catch (IOException e) {
      throw new UModuleException("cannot read " + jar + ": " + JarContent.reason(e), e);
    }
    JarModule module = new JarModule(content, libraries);
    module.initialize();
    return module;
  }
}
