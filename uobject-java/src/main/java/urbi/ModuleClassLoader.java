package urbi;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.classfile.Attributes;
import java.lang.classfile.ClassFile;
import java.lang.classfile.ClassModel;
import java.lang.classfile.constantpool.MemberRefEntry;
import java.lang.classfile.constantpool.PoolEntry;
import java.net.MalformedURLException;
import java.net.URI;
import java.net.URL;
import java.net.URLConnection;
import java.net.URLStreamHandler;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;

/** The classes and resources of one module. It looks into the module before it asks its parent. */
final class ModuleClassLoader extends ClassLoader {
  private static final List<String> STARTERS = List.of("UStart", "UStartRename", "UStartHub");
  private static final String ANNOTATION = "Lurbi/UStart;";

  private final JarContent content;
  private UModule module;

  ModuleClassLoader(JarContent content, ClassLoader parent) {
    super(content.file().getFileName().toString(), parent);
    this.content = content;
  }

  UModule module() {
    return module;
  }

  void setModule(UModule of) {
    module = of;
  }

  /** Initializes the classes that declare UObjects. */
  void initialize() {
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

  /** Whether a class calls what declares UObjects, or has the annotation which does. */
  private boolean declares(String name) {
    ClassModel model;
    try {
      model = ClassFile.of().parse(content.classBytes(name));
      for (PoolEntry entry : model.constantPool()) {
        if (entry instanceof MemberRefEntry member
            && STARTERS.contains(member.name().stringValue())) {
          return true;
        }
      }
      return model
          .findAttribute(Attributes.runtimeVisibleAnnotations())
          .map(all ->
              all.annotations().stream()
                  .anyMatch(annotation -> annotation.className().equalsString(ANNOTATION)))
          .orElse(false);
    } catch (IllegalArgumentException e) {
      throw failure(name, "not a class file", e);
    }
  }

  @Override
  protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
    synchronized (getClassLoadingLock(name)) {
      Class<?> known = findLoadedClass(name);
      if (known != null) {
        return known;
      }
      byte[] bytes = content.classBytes(name);
      if (bytes == null || name.startsWith("java.") || name.startsWith("urbi.")) {
        return super.loadClass(name, resolve);
      }
      return defineClass(name, bytes, 0, bytes.length);
    }
  }

  // ------------------------------------------------------------------ resources

  @Override
  protected URL findResource(String name) {
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
