package urbi;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A class of UObjects, as a context needs it: a name and what makes one. Those of Java are declared
 * by {@link UObject#UStart}; those written in another language make {@link UObject}s that stand for
 * theirs.
 */
public final class UClass {
  /** Makes the Java side of an urbiscript object. */
  @FunctionalInterface
  public interface Factory {
    /**
     * Makes a new object.
     *
     * @param name to be passed to the constructor of {@link UObject}
     * @throws Exception whatever the constructor throws
     */
    UObject create(String name) throws Exception;
  }

  /** The class of the object being made, which its constructor asks for. */
  private record Creation(UClass type, String name) {}

  private static final ScopedValue<Creation> CREATION = ScopedValue.newInstance();

  private final String name;
  private final UModule module;
  private final Factory factory;
  private final UTaskQueue queue = new UTaskQueue();

  /**
   * @param name in urbiscript
   * @param module where the class comes from
   */
  public UClass(String name, UModule module, Factory factory) {
    this.name = Objects.requireNonNull(name, "name");
    this.module = Objects.requireNonNull(module, "module");
    this.factory = Objects.requireNonNull(factory, "factory");
  }

  /**
   * The class of objects of a Java class, under its simple name; it need not be declared.
   *
   * @throws UModuleException if it has no constructor that takes a String
   */
  public static UClass of(Class<? extends UObject> javaClass) {
    return UModule.of(javaClass.getClassLoader()).typeOf(javaClass);
  }

  /** The name in urbiscript. */
  public String name() {
    return name;
  }

  /** Where it comes from. */
  public UModule module() {
    return module;
  }

  /** Where threaded calls wait that exclude one another in the whole class. */
  UTaskQueue queue() {
    return queue;
  }

  /**
   * Makes an object; what its annotations say is bound.
   *
   * @throws Exception what the constructor threw
   */
  public UObject create(String objectName) throws Exception {
    return ScopedValue.where(CREATION, new Creation(this, objectName))
        .call(() -> {
          UObject made = factory.create(objectName);
          Annotations.bind(made);
          return made;
        });
  }

  /** The class of an object whose constructor has begun. */
  static UClass of(Class<? extends UObject> javaClass, @Nullable String objectName) {
    Creation creation = CREATION.isBound() ? CREATION.get() : null;
    if (creation != null && creation.name.equals(objectName)) {
      return creation.type;
    }
    return UModule.of(javaClass.getClassLoader()).typeOf(javaClass);
  }

  @Override
  public String toString() {
    return name;
  }
}
