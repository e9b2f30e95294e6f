package urbi.spi;

import java.util.List;
import org.jspecify.annotations.Nullable;
import urbi.UModule;

/** The UObjects of a jar, or of a folder of classes. */
final class JarModule extends UModule {
  private final ModuleClassLoader loader;

  JarModule(JarContent content, List<UModule> libraries) {
    super(content.file().getFileName().toString());
    loader = new ModuleClassLoader(content, this, libraries, ModuleParent.LOADER);
  }

  /** Has its classes declare themselves. */
  void initialize() {
    loader.initialize();
  }

  /** A class of the jar by its name, for other modules; null if it has none. */
  @Nullable Class<?> findClass(String className) {
    return loader.own(className);
  }
}
