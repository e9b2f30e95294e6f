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

  /** A module to be filled by hand, for classes that are not of Java. */
  public UModule(String name) {
    this.name = Objects.requireNonNull(name, "name");
  }

  /**
   * Loads a jar: every class in it that calls {@link UObject#UStart} or {@link UObject#UStartHub}
   * when it is initialized, or is annotated with {@link UStart}, is initialized now.
   *
   * @throws UModuleException if the file cannot be read or is no jar, has no such class, or one
   *     that cannot be loaded
   */
  public static UModule load(Path jar) {
    JarContent content;
    try {
      content = JarContent.read(jar);
    } catch (IOException e) {
      throw new UModuleException("cannot read " + jar + ": " + JarContent.reason(e), e);
    }
    var classLoader = new ModuleClassLoader(content, UModule.class.getClassLoader());
    UModule module = new UModule(jar.getFileName().toString());
    classLoader.setModule(module);
    classLoader.initialize();
    if (module.classes.isEmpty() && module.hubs.isEmpty()) {
      throw new UModuleException("no UObject in " + jar);
    }
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
