package urbi.spi;

import java.nio.file.Path;
import urbi.UModule;
import urbi.UModuleException;

/**
 * Loads modules that are not jars. Implementations are found by {@link java.util.ServiceLoader}.
 */
public interface ModuleLoader {
  /** What the names of such files end with, with the dot. */
  String suffix();

  /**
   * Loads a file.
   *
   * @throws UModuleException if it is no module
   */
  UModule load(Path file);
}
