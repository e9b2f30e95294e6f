package urbi;

import java.io.Serializable;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.invoke.SerializedLambda;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Type;
import java.util.List;

/**
 * Method references that can be bound: {@code bind("add", this::add)}. They can be serialized, and
 * so tell which types their arguments have.
 */
public final class UFunctions {
  private UFunctions() {}

  /** A function, or a procedure, that can be bound. */
  public sealed interface Bindable extends Serializable
      permits F0, F1, F2, F3, F4, P0, P1, P2, P3, P4 {}

  /** A function without arguments. */
  @FunctionalInterface
  public non-sealed interface F0<R> extends Bindable {
    R apply() throws Exception;
  }

  /** A function of one argument. */
  @FunctionalInterface
  public non-sealed interface F1<A, R> extends Bindable {
    R apply(A a) throws Exception;
  }

  /** A function of two arguments. */
  @FunctionalInterface
  public non-sealed interface F2<A, B, R> extends Bindable {
    R apply(A a, B b) throws Exception;
  }

  /** A function of three arguments. */
  @FunctionalInterface
  public non-sealed interface F3<A, B, C, R> extends Bindable {
    R apply(A a, B b, C c) throws Exception;
  }

  /** A function of four arguments. */
  @FunctionalInterface
  public non-sealed interface F4<A, B, C, D, R> extends Bindable {
    R apply(A a, B b, C c, D d) throws Exception;
  }

  /** A procedure without arguments. */
  @FunctionalInterface
  public non-sealed interface P0 extends Bindable {
    void run() throws Exception;
  }

  /** A procedure of one argument. */
  @FunctionalInterface
  public non-sealed interface P1<A> extends Bindable {
    void run(A a) throws Exception;
  }

  /** A procedure of two arguments. */
  @FunctionalInterface
  public non-sealed interface P2<A, B> extends Bindable {
    void run(A a, B b) throws Exception;
  }

  /** A procedure of three arguments. */
  @FunctionalInterface
  public non-sealed interface P3<A, B, C> extends Bindable {
    void run(A a, B b, C c) throws Exception;
  }

  /** A procedure of four arguments. */
  @FunctionalInterface
  public non-sealed interface P4<A, B, C, D> extends Bindable {
    void run(A a, B b, C c, D d) throws Exception;
  }

  /**
   * A method reference as a function.
   *
   * @param name by which errors call it
   */
  static UCallback callback(String name, Bindable function) {
    try {
      Method call = callMethod(function);
      List<Class<?>> types = types(function);
      MethodHandle handle = MethodHandles.lookup().unreflect(call).bindTo(function);
      MethodType type = MethodType.methodType(handle.type().returnType(), types);
      return UCallback.of(name, handle.asType(type), List.<Type>copyOf(types));
    } catch (ReflectiveOperationException e) {
      throw new IllegalArgumentException(name + ": its types are not known", e);
    }
  }

  private static Method callMethod(Bindable function) {
    for (Class<?> declared : function.getClass().getInterfaces()) {
      if (Bindable.class.isAssignableFrom(declared)) {
        for (Method method : declared.getMethods()) {
          if (Modifier.isAbstract(method.getModifiers())) {
            return method;
          }
        }
      }
    }
    throw new IllegalArgumentException("no function: " + function);
  }

  /** The types of the arguments, as the compiler has inferred them. */
  private static List<Class<?>> types(Bindable function) throws ReflectiveOperationException {
    Method writeReplace = function.getClass().getDeclaredMethod("writeReplace");
    writeReplace.setAccessible(true);
    SerializedLambda lambda = (SerializedLambda) writeReplace.invoke(function);
    return MethodType.fromMethodDescriptorString(
            lambda.getInstantiatedMethodType(), function.getClass().getClassLoader())
        .parameterList();
  }
}
