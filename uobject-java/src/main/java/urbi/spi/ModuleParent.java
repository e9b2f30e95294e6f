package urbi.spi;

import java.io.File;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import urbi.UModuleException;

/**
 * The parent class loader of modules. It finds shared classes in the package {@code urbi}, in the
 * JDK, and in the jars and folders of the system property {@code urbi.classpath} ({@code
 * urbi-launch-java --classpath}), which they share.
 */
final class ModuleParent {
  static final ClassLoader LOADER = loader(System.getProperty("urbi.classpath", ""));

  private ModuleParent() {}

  private static ClassLoader loader(String classPath) {
    ClassLoader own = ModuleParent.class.getClassLoader();
    List<URL> urls = new ArrayList<>();
    for (String part : classPath.split(File.pathSeparator)) {
      if (!part.isEmpty()) {
        try {
          urls.add(Path.of(part).toUri().toURL());
        } catch (MalformedURLException e) {
          throw new UModuleException("cannot use " + part + " as class path", e);
        }
      }
    }
    return urls.isEmpty() ? own : new URLClassLoader("classpath", urls.toArray(URL[]::new), own);
  }
}
