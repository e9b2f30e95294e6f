package urbi.spi;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.MalformedURLException;
import java.net.URI;
import java.net.URL;
import java.net.URLConnection;
import java.net.URLStreamHandler;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import urbi.UModule;
import urbi.UModuleException;
import urbi.UObject;
import urbi.UObjectHub;
import urbi.UStart;

/** The classes and resources of one module. It looks into the module before it asks its parent. */
final class ModuleClassLoader extends ClassLoader implements UModule.Loader {
  private final JarContent content;
  private final UModule module;
  private final List<UModule> libraries;

  ModuleClassLoader(
      JarContent content, UModule module, List<UModule> libraries, ClassLoader parent) {
    super(content.file().getFileName().toString(), parent);
    this.content = content;
    this.module = module;
    this.libraries = libraries;
  }

  @Override
  public UModule module() {
    return module;
  }

  /** Initializes the classes that declare UObjects: those of the index, or of all that are here. */
  void initialize() {
    Optional<List<String>> index = ModuleIndex.read(content.entries().get("META-INF/MANIFEST.MF"));
    if (index.isPresent()) {
      index.get().forEach(this::initialize);
      return;
    }
    for (String name : content.classNames()) {
      if (declares(name)) {
        initialize(name);
      }
    }
  }

  private void initialize(String name) {
    try {
      Class<?> loaded = Class.forName(name, true, this);
      UStart annotation = loaded.getAnnotation(UStart.class);
      if (annotation != null) {
        start(loaded, annotation.value());
      }
    } catch (ExceptionInInitializerError e) {
      Throwable cause = e.getCause() == null ? e : e.getCause();
      throw failure(name, "its initialization failed: " + cause, e);
    } catch (ClassNotFoundException | LinkageError e) {
      throw failure(name, explain(e), e);
    }
  }

  private static void start(Class<?> loaded, String name) {
    if (UObjectHub.class.isAssignableFrom(loaded)) {
      UObject.UStartHub(loaded.asSubclass(UObjectHub.class));
    } else if (!UObject.class.isAssignableFrom(loaded)) {
      throw new UModuleException(loaded.getName() + " is annotated with UStart, but is no UObject");
    } else if (name.isEmpty()) {
      UObject.UStart(loaded.asSubclass(UObject.class));
    } else {
      UObject.UStartRename(loaded.asSubclass(UObject.class), name);
    }
  }

  private UModuleException failure(String name, String why, Throwable cause) {
    return new UModuleException(
        "cannot load the class " + name + " of " + content.file() + ": " + why, cause);
  }

  private static String explain(Throwable e) {
    for (Throwable cause = e; cause != null; cause = cause.getCause()) {
      if (cause instanceof NoClassDefFoundError || cause instanceof ClassNotFoundException) {
        if (cause.getMessage() != null && cause.getCause() == null) {
          return "missing class " + cause.getMessage().replace('/', '.');
        }
      }
    }
    return e.toString();
  }

  private boolean declares(String name) {
    try {
      return ModuleIndex.declares(content.classBytes(name));
    } catch (IllegalArgumentException e) {
      throw failure(name, "not a class file", e);
    }
  }

  @Override
  protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
    Class<?> own = own(name);
    return own == null ? super.loadClass(name, resolve) : own;
  }

  /** A class of the jar; null if it has none of that name. */
  @Nullable Class<?> own(String name) {
    synchronized (getClassLoadingLock(name)) {
      Class<?> known = findLoadedClass(name);
      if (known != null) {
        return known;
      }
      byte[] bytes = content.classBytes(name);
      return bytes == null || name.startsWith("java.") || name.startsWith("urbi.")
          ? null
          : defineClass(name, bytes, 0, bytes.length);
    }
  }

  /** What neither the jar nor the parent has may be in a library. */
  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    for (UModule library : libraries) {
      Class<?> found = library instanceof JarModule jar ? jar.findClass(name) : null;
      if (found != null) {
        return found;
      }
    }
    throw new ClassNotFoundException(name);
  }

  // ------------------------------------------------------------------ resources

  @Override
  protected @Nullable URL findResource(String name) {
    byte[] bytes = content.entries().get(name);
    if (bytes == null) {
      return null;
    }
    try {
      return URL.of(URI.create("memory:/" + name.replace(" ", "%20")), new Handler(bytes));
    } catch (MalformedURLException | IllegalArgumentException e) {
      return null;
    }
  }

  @Override
  protected Enumeration<URL> findResources(String name) {
    URL found = findResource(name);
    return found == null ? Collections.emptyEnumeration() : Collections.enumeration(List.of(found));
  }

  /** Opens a resource that is in memory. */
  private static final class Handler extends URLStreamHandler {
    private final byte[] bytes;

    Handler(byte[] bytes) {
      this.bytes = bytes;
    }

    @Override
    protected URLConnection openConnection(URL url) {
      return new URLConnection(url) {
        @Override
        public void connect() throws IOException {
          connected = true;
        }

        @Override
        public InputStream getInputStream() {
          return new ByteArrayInputStream(bytes);
        }

        @Override
        public int getContentLength() {
          return bytes.length;
        }
      };
    }
  }
}
