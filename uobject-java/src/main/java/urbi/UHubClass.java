package urbi;

import java.util.Objects;

/** A class of hubs, of which each context makes one instance; see {@link UObject#UStartHub}. */
public final class UHubClass {
  /** Makes the hub. */
  @FunctionalInterface
  public interface Factory {
    /** Makes the hub; it is given its own name. */
    UObjectHub create(String name) throws Exception;
  }

  private final String name;
  private final UModule module;
  private final Factory factory;

  /**
   * @param name of the class
   * @param module where it comes from
   */
  public UHubClass(String name, UModule module, Factory factory) {
    this.name = Objects.requireNonNull(name, "name");
    this.module = Objects.requireNonNull(module, "module");
    this.factory = Objects.requireNonNull(factory, "factory");
  }

  public String name() {
    return name;
  }

  /** Where it comes from. */
  public UModule module() {
    return module;
  }

  /**
   * Makes the hub.
   *
   * @throws Exception what the constructor threw
   */
  public UObjectHub create() throws Exception {
    return factory.create(name);
  }

  @Override
  public String toString() {
    return name;
  }
}
