package urbi;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** Finds the methods that are bound by their names. */
final class Methods {
  /** How many arguments a bound function may have. */
  private static final int MAX_ARGUMENTS = 16;

  private static final Map<String, Class<?>> NAMES =
      Map.ofEntries(
          Map.entry("boolean", boolean.class),
          Map.entry("bool", boolean.class),
          Map.entry("byte", byte.class),
          Map.entry("char", char.class),
          Map.entry("short", short.class),
          Map.entry("int", int.class),
          Map.entry("long", long.class),
          Map.entry("float", float.class),
          Map.entry("double", double.class),
          Map.entry("void", void.class));

  private Methods() {}

  /**
   * The method of that name, if there is only one, or one that overrides or hides the others.
   *
   * @throws IllegalArgumentException if there is none, or more
   */
  static Method find(Class<?> type, String name) {
    for (Class<?> declaring = type; declaring != null; declaring = declaring.getSuperclass()) {
      List<Method> found = new ArrayList<>();
      for (Method method : declaring.getDeclaredMethods()) {
        if (method.getName().equals(name) && !method.isBridge() && !method.isSynthetic()) {
          found.add(method);
        }
      }
      if (found.size() > 1) {
        throw new IllegalArgumentException(
            type.getName()
                + " has several methods "
                + name
                + ": give the types of the arguments to choose one");
      }
      if (!found.isEmpty()) {
        return found.getFirst();
      }
    }
    for (Method method : type.getMethods()) {
      if (method.getName().equals(name) && !method.isBridge()) {
        return method;
      }
    }
    throw new IllegalArgumentException(type.getName() + " has no method " + name);
  }

  /**
   * The method of that name with arguments of these types.
   *
   * @param types names as in Java: {@code double}, {@code java.lang.String}; without a package when
   *     it is {@code java.lang} or this one
   * @throws IllegalArgumentException if there is none, or no such type
   */
  static Method find(Class<?> type, String name, String[] types) {
    Class<?>[] parameters = new Class<?>[types.length];
    for (int i = 0; i < types.length; i++) {
      parameters[i] = type(type, types[i].strip());
    }
    for (Class<?> declaring = type; declaring != null; declaring = declaring.getSuperclass()) {
      try {
        return declaring.getDeclaredMethod(name, parameters);
      } catch (NoSuchMethodException e) {
        // One that is inherited, then.
      }
    }
    throw new IllegalArgumentException(
        type.getName() + " has no method " + name + "(" + String.join(", ", types) + ")");
  }

  private static Class<?> type(Class<?> context, String name) {
    Class<?> known = NAMES.get(name);
    if (known != null) {
      return known;
    }
    if (name.endsWith("[]")) {
      return type(context, name.substring(0, name.length() - 2)).arrayType();
    }
    String own = context.getPackageName();
    for (String full :
        List.of(
            name,
            "java.lang." + name,
            "urbi." + name,
            "java.util." + name,
            own.isEmpty() ? name : own + "." + name)) {
      try {
        return Class.forName(full, false, context.getClassLoader());
      } catch (ClassNotFoundException e) {
        // Perhaps it is in the next package.
      }
    }
    throw new IllegalArgumentException("no such type: " + name);
  }

  /**
   * A method of an object as a function.
   *
   * @param name by which errors call it
   * @throws IllegalArgumentException if it has too many arguments
   */
  static UCallback callback(String name, Object target, Method method) {
    if (method.getParameterCount() > MAX_ARGUMENTS) {
      throw new IllegalArgumentException(
          name
              + " has "
              + method.getParameterCount()
              + " arguments, "
              + MAX_ARGUMENTS
              + " is the most that a function can be bound with");
    }
    MethodHandle handle = handle(method);
    if (!Modifier.isStatic(method.getModifiers())) {
      handle = handle.bindTo(target);
    }
    return UCallback.of(name, handle, Arrays.asList(method.getGenericParameterTypes()));
  }

  private static MethodHandle handle(Method method) {
    try {
      method.setAccessible(true);
      return MethodHandles.lookup().unreflect(method);
    } catch (IllegalAccessException | RuntimeException e) {
      throw new IllegalArgumentException("cannot call " + method + ": " + e.getMessage(), e);
    }
  }
}
