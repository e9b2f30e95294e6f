package urbi;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.WeakHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;

/**
 * A set of UObject classes that are loaded together: those of a jar, of a shared library, or of the
 * program itself. {@link UObject#UStart} adds a class to the module whose class loader has loaded
 * it.
 *
 * <p>Files with modules are loaded by {@code urbi.spi.ModuleFiles}.
 */
public class UModule {
  /** A class loader that loads the classes of one module. */
  public interface Loader {
    UModule module();
  }

  /** The modules of the other class loaders. */
  private static final Map<ClassLoader, UModule> PROGRAMS = new WeakHashMap<>();

  private final String name;
  private final List<UClass> classes = new CopyOnWriteArrayList<>();
  private final List<UHubClass> hubs = new CopyOnWriteArrayList<>();
  private final List<UContext> contexts = new CopyOnWriteArrayList<>();
  private final UTaskQueue queue = new UTaskQueue();
  private final Runnable whenLeft;

  /** A module to be filled by hand, for classes that are not of Java. */
  public UModule(String name) {
    this(name, () -> {});
  }

  /**
   * A module to be filled by hand.
   *
   * @param whenLeft is run when the last context no longer uses it, and before its objects have all
   *     been ended
   */
  public UModule(String name, Runnable whenLeft) {
    this.name = Objects.requireNonNull(name, "name");
    this.whenLeft = Objects.requireNonNull(whenLeft, "whenLeft");
  }

  /** The module of the classes that a class loader has loaded. */
  static UModule of(ClassLoader classLoader) {
    if (classLoader instanceof Loader own) {
      return own.module();
    }
    synchronized (PROGRAMS) {
      return PROGRAMS.computeIfAbsent(classLoader, key -> new UModule("program"));
    }
  }

  /** The one context in which the module of a class loader is started, or null. */
  static @Nullable UContext contextOf(ClassLoader classLoader) {
    UModule module;
    if (classLoader instanceof Loader own) {
      module = own.module();
    } else {
      synchronized (PROGRAMS) {
        module = PROGRAMS.get(classLoader);
      }
    }
    return module != null && module.contexts.size() == 1 ? module.contexts.getFirst() : null;
  }

  /** What it is called: the name of the file. */
  public final String name() {
    return name;
  }

  /** Its classes, in the order in which they were declared. */
  public final List<UClass> classes() {
    return List.copyOf(classes);
  }

  /** Its hubs, in the order in which they were declared. */
  public final List<UHubClass> hubs() {
    return List.copyOf(hubs);
  }

  /** Where threaded calls wait that exclude one another in the whole module. */
  UTaskQueue queue() {
    return queue;
  }

  /** Declares a class; contexts in which the module is started already get it now. */
  public final void add(UClass type) {
    classes.removeIf(known -> known.name().equals(type.name()));
    classes.add(type);
    contexts.forEach(context -> context.start(type));
  }

  /** Declares a class of hubs; contexts in which the module is started already get it now. */
  public final void add(UHubClass type) {
    hubs.removeIf(known -> known.name().equals(type.name()));
    hubs.add(type);
    contexts.forEach(context -> context.startHub(type));
  }

  /**
   * Starts all its hubs and then its classes in a context, and those that are declared later.
   *
   * @throws RuntimeException what the first one throws that cannot be started
   */
  public final void startIn(UContext context) {
    contexts.add(context);
    hubs.forEach(context::startHub);
    classes.forEach(context::start);
  }

  /** The module is no longer used in a context. */
  public final void leave(UContext context) {
    if (contexts.remove(context) && contexts.isEmpty()) {
      whenLeft.run();
    }
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
