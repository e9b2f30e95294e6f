package urbi;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;

/** The constructor that UObjects and hubs have: with their name as its only argument. */
final class Constructors<T> {
  private final Constructor<?> constructor;
  private final Class<T> result;

  private Constructors(Constructor<?> constructor, Class<T> result) {
    this.constructor = constructor;
    this.result = result;
  }

  /**
   * Finds the constructor of a class.
   *
   * @throws UModuleException if the class has none
   */
  static <T> Constructors<T> of(Class<?> type, Class<T> result) {
    if (!result.isAssignableFrom(type)) {
      throw new UModuleException(type.getName() + " is no " + result.getSimpleName());
    }
    try {
      Constructor<?> constructor = type.getDeclaredConstructor(String.class);
      constructor.setAccessible(true);
      return new Constructors<>(constructor, result);
    } catch (NoSuchMethodException e) {
      throw new UModuleException(type.getName() + " has no constructor that takes a String", e);
    }
  }

  /** Makes an object; throws what the constructor throws. */
  T newInstance(String name) throws Exception {
    try {
      return result.cast(constructor.newInstance(name));
    } catch (InvocationTargetException e) {
      switch (e.getCause()) {
        case Exception exception -> throw exception;
        case Error error -> throw error;
        case null, default -> throw e;
      }
    } catch (InstantiationException e) {
      throw new UModuleException(constructor.getDeclaringClass().getName() + " is abstract", e);
    }
  }
}
