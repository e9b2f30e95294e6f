package urbi;

import java.nio.file.Path;

/**
 * Loads modules that are no jars. Those who implement it are found by {@link
 * java.util.ServiceLoader}.
 */
public interface UModuleLoader {
  /** What the names of such files end with, with the dot. */
  String suffix();

  /**
   * Loads a file.
   *
   * @throws UModuleException if it is no module
   */
  UModule load(Path file);
}
