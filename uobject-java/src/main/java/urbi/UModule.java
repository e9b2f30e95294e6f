package urbi;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.WeakHashMap;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * The classes of UObjects that come together: those of a jar, of a shared library, or of the
 * program itself. {@link UObject#UStart} adds a class to the module whose class loader has loaded
 * it.
 *
 * <p>A jar is read whole when it is loaded, into a class loader of its own; the file may be
 * replaced at any time. Two contexts that load the same jar share nothing.
 */
public final class UModule {
  /** The modules of class loaders that are not made here. */
  private static final Map<ClassLoader, UModule> PROGRAMS = new WeakHashMap<>();

  private final String name;
  private final List<UClass> classes = new CopyOnWriteArrayList<>();
  private final List<UHubClass> hubs = new CopyOnWriteArrayList<>();
  private final List<UContext> contexts = new CopyOnWriteArrayList<>();
  private final UTaskQueue queue = new UTaskQueue();
  private ModuleClassLoader loader;

  /** A module to be filled by hand, for classes that are not of Java. */
  public UModule(String name) {
    this.name = Objects.requireNonNull(name, "name");
  }

  /**
   * Loads a jar, or a folder of classes: every class in it that calls {@link UObject#UStart} or
   * {@link UObject#UStartHub} when it is initialized, or is annotated with {@link UStart}, is
   * initialized now; which these are {@linkplain UModuleIndex the manifest} may say.
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
    if (module.classes.isEmpty() && module.hubs.isEmpty()) {
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
    JarContent content;
    try {
      content = JarContent.read(jar);
    } catch (IOException e) {
      throw new UModuleException("cannot read " + jar + ": " + JarContent.reason(e), e);
    }
    UModule module = new UModule(jar.getFileName().toString());
    module.loader = new ModuleClassLoader(content, module, libraries, ModuleParent.LOADER);
    module.loader.initialize();
    return module;
  }

  /** The module of the classes that a class loader has loaded. */
  static UModule of(ClassLoader classLoader) {
    if (classLoader instanceof ModuleClassLoader own) {
      return own.module();
    }
    synchronized (PROGRAMS) {
      return PROGRAMS.computeIfAbsent(classLoader, key -> new UModule("program"));
    }
  }

  /** The one context in which the module of a class loader is started, or null. */
  static UContext contextOf(ClassLoader classLoader) {
    UModule module;
    if (classLoader instanceof ModuleClassLoader own) {
      module = own.module();
    } else {
      synchronized (PROGRAMS) {
        module = PROGRAMS.get(classLoader);
      }
    }
    return module != null && module.contexts.size() == 1 ? module.contexts.getFirst() : null;
  }

  /** A class of the jar by its name, for other modules; null if it has none. */
  Class<?> findClass(String className) {
    return loader == null ? null : loader.own(className);
  }

  /** What it is called: the name of the file. */
  public String name() {
    return name;
  }

  /** Its classes, in the order in which they were declared. */
  public List<UClass> classes() {
    return List.copyOf(classes);
  }

  /** Its hubs, in the order in which they were declared. */
  public List<UHubClass> hubs() {
    return List.copyOf(hubs);
  }

  /** Where threaded calls wait that exclude one another in the whole module. */
  UTaskQueue queue() {
    return queue;
  }

  /** Declares a class; contexts in which the module is started already get it now. */
  public void add(UClass type) {
    classes.removeIf(known -> known.name().equals(type.name()));
    classes.add(type);
    contexts.forEach(context -> context.start(type));
  }

  /** Declares a class of hubs; contexts in which the module is started already get it now. */
  public void add(UHubClass type) {
    hubs.removeIf(known -> known.name().equals(type.name()));
    hubs.add(type);
    contexts.forEach(context -> context.startHub(type));
  }

  /**
   * Starts all its hubs and then its classes in a context, and those that are declared later.
   *
   * @throws RuntimeException what the first one throws that cannot be started
   */
  public void startIn(UContext context) {
    contexts.add(context);
    hubs.forEach(context::startHub);
    classes.forEach(context::start);
  }

  /** It is no longer used in a context. */
  public void leave(UContext context) {
    contexts.remove(context);
  }

  /** The class of objects of a Java class, which need not be declared. */
  UClass typeOf(Class<? extends UObject> javaClass) {
    Optional<UClass> known =
        classes.stream().filter(type -> type.name().equals(simpleName(javaClass))).findFirst();
    return known.orElseGet(() -> typeOf(javaClass, simpleName(javaClass)));
  }

  /** The class of objects of a Java class, under a name. */
  UClass typeOf(Class<? extends UObject> javaClass, String urbiName) {
    return new UClass(urbiName, this, Constructors.of(javaClass, UObject.class)::newInstance);
  }

  static String simpleName(Class<?> javaClass) {
    String full = javaClass.getName();
    return full.substring(Math.max(full.lastIndexOf('.'), full.lastIndexOf('$')) + 1);
  }

  @Override
  public String toString() {
    return name;
  }
}
