package org.urbi.kernel.script;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Proxy;
import java.util.function.BiPredicate;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.embed.JavaValues;
import org.urbi.kernel.embed.UrbiValue;

/** Implements a Java interface by an urbiscript object: each method calls the slot of its name. */
final class InterfaceProxy implements InvocationHandler {
  private final UrbiValue object;

  private InterfaceProxy(UrbiValue object) {
    this.object = object;
  }

  /**
   * The object as an implementation of an interface; null when it lacks a method.
   *
   * @throws IllegalArgumentException if the type is no interface
   */
  static <T> @Nullable T of(
      UrbiValue object, Class<T> type, BiPredicate<UrbiValue, String> understands) {
    if (type == null || !type.isInterface()) {
      throw new IllegalArgumentException("no interface: " + type);
    }
    for (Method method : type.getMethods()) {
      if (Modifier.isAbstract(method.getModifiers())
          && !understands.test(object, method.getName())) {
        return null;
      }
    }
    return type.cast(
        Proxy.newProxyInstance(
            type.getClassLoader(), new Class<?>[] {type}, new InterfaceProxy(object)));
  }

  @Override
  public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] arguments)
      throws Throwable {
    Object[] given = arguments == null ? new Object[0] : arguments;
    if (method.getDeclaringClass() == Object.class) {
      return switch (method.getName()) {
        case "equals" -> proxy == given[0];
        case "hashCode" -> System.identityHashCode(proxy);
        default -> object.toString();
      };
    }
    if (method.isDefault()) {
      try {
        return InvocationHandler.invokeDefault(proxy, method, given);
      } catch (InvocationTargetException e) {
        throw e.getCause();
      }
    }
    return JavaValues.as(object.call(method.getName(), given), method.getReturnType());
  }
}
