package org.urbi.kernel.uobject;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Type;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UCallback;
import urbi.UCast;
import urbi.UCastException;
import urbi.UObject;
import urbi.UValue;
import urbi.UVar;
import urbi.spi.ArgumentTypes;

/**
 * Calls Java functions with values of urbiscript: a converter for each parameter is chosen once,
 * when the function is bound. Numbers, strings and the like are converted directly, other types by
 * way of a {@link UValue}.
 */
final class Converters {
  private static final MethodHandles.Lookup LOOKUP = MethodHandles.lookup();

  private final PluggedContext context;
  private final ValueConversion conversion;
  private final Values values;

  /** Converters that need nothing but the argument. */
  private final Map<Class<?>, MethodHandle> direct = new HashMap<>();

  Converters(PluggedContext context, ValueConversion conversion) {
    this.context = context;
    this.conversion = conversion;
    this.values = context.interpreter().values();
    direct(double.class, "number");
    direct(float.class, "floatNumber");
    direct(long.class, "longNumber");
    direct(int.class, "integer");
    direct(short.class, "shortInteger");
    direct(byte.class, "byteInteger");
    direct.put(String.class, own("text", String.class, UrbiObject.class));
    direct.put(UValue.class, own("value", UValue.class, UrbiObject.class));
    direct.put(UVar.class, own("variable", UVar.class, UrbiObject.class));
    direct.put(boolean.class, own("truth", boolean.class, UrbiObject.class));
    direct.put(UrbiObject.class, MethodHandles.identity(UrbiObject.class));
  }

  private void direct(Class<?> type, String method) {
    direct.put(type, find(() -> LOOKUP.findStatic(Converters.class, method, methodType(type))));
  }

  private static MethodType methodType(Class<?> type) {
    return MethodType.methodType(type, UrbiObject.class);
  }

  private interface Finding {
    MethodHandle find() throws ReflectiveOperationException;
  }

  private static MethodHandle find(Finding finding) {
    try {
      return finding.find();
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  private MethodHandle own(String name, Class<?> result, Class<?>... parameters) {
    return find(() -> LOOKUP.bind(this, name, MethodType.methodType(result, parameters)));
  }

  // ------------------------------------------------------------------ whole functions

  /** A method handle from an array of urbiscript arguments to an urbiscript result. */
  MethodHandle whole(UCallback callback) {
    MethodHandle handle = callback.handle();
    List<Type> types = callback.parameterTypes();
    for (int i = 0; i < types.size(); i++) {
      MethodHandle argument = argument(types.get(i), handle.type().parameterType(i));
      handle = MethodHandles.filterArguments(handle, i, argument);
    }
    return withResult(handle)
        .asSpreader(UrbiObject[].class, types.size())
        .asType(MethodType.methodType(UrbiObject.class, UrbiObject[].class));
  }

  private MethodHandle withResult(MethodHandle handle) {
    Class<?> type = handle.type().returnType();
    if (type == void.class) {
      return MethodHandles.filterReturnValue(
          handle, MethodHandles.constant(UrbiObject.class, values.voidObject));
    }
    MethodHandle result;
    if (type == double.class) {
      result = own("ofNumber", UrbiObject.class, double.class);
    } else if (type == boolean.class) {
      result = own("ofTruth", UrbiObject.class, boolean.class);
    } else if (type == String.class) {
      result = own("ofText", UrbiObject.class, String.class);
    } else if (type.isPrimitive() && type != char.class) {
      result =
          own("ofNumber", UrbiObject.class, double.class)
              .asType(MethodType.methodType(UrbiObject.class, type));
    } else {
      result =
          own("waited", UrbiObject.class, Object.class)
              .asType(MethodType.methodType(UrbiObject.class, type));
    }
    return MethodHandles.filterReturnValue(handle, result);
  }

  /** A method handle from an urbiscript value to a Java argument. */
  private MethodHandle argument(Type type, Class<?> raw) {
    Class<?> primitive = MethodType.methodType(raw).unwrap().returnType();
    MethodHandle known = direct.get(primitive);
    if (known != null) {
      return known.asType(MethodType.methodType(raw, UrbiObject.class));
    }
    return MethodHandles.insertArguments(
            own("cast", Object.class, Type.class, UrbiObject.class), 0, type)
        .asType(MethodType.methodType(raw, UrbiObject.class));
  }

  /** The arguments of a call, converted one by one. */
  Object[] arguments(UCallback callback, UrbiObject[] given) throws Throwable {
    Object[] converted = new Object[given.length];
    for (int i = 0; i < given.length; i++) {
      converted[i] = argument(callback, i, given[i]);
    }
    return converted;
  }

  /** One argument of a function. */
  Object argument(UCallback callback, int index, UrbiObject given) throws Throwable {
    MethodHandle converter =
        argument(
            callback.parameterTypes().get(index), callback.handle().type().parameterType(index));
    return converter.invoke(given);
  }

  // ------------------------------------------------------------------ arguments

  private static double number(UrbiObject given) {
    return given instanceof UrbiFloat number ? number.value() : otherNumber(given);
  }

  private static double otherNumber(UrbiObject given) {
    Values values = given.world().values();
    if (given == values.trueObject || given == values.falseObject) {
      return given == values.trueObject ? 1 : 0;
    }
    if (given instanceof UrbiString text) {
      try {
        return new UValue(text.value()).doubleValue();
      } catch (UCastException e) {
        // The message says what was given.
      }
    }
    throw new ConversionFailure(given, "Float", null);
  }

  private static float floatNumber(UrbiObject given) {
    return (float) number(given);
  }

  private static long longNumber(UrbiObject given) {
    return (long) number(given);
  }

  private static int integer(UrbiObject given) {
    return (int) longNumber(given);
  }

  private static short shortInteger(UrbiObject given) {
    return (short) longNumber(given);
  }

  private static byte byteInteger(UrbiObject given) {
    return (byte) longNumber(given);
  }

  private boolean truth(UrbiObject given) {
    if (given == values.trueObject || given == values.falseObject) {
      return given == values.trueObject;
    }
    if (given instanceof UrbiFloat number) {
      return number.value() != 0;
    }
    throw new ConversionFailure(given, "Boolean", null);
  }

  private @Nullable String text(UrbiObject given) {
    if (given instanceof UrbiString string) {
      return Utf8Text.toJava(string.value());
    }
    return (String) cast(String.class, given);
  }

  private UValue value(UrbiObject given) {
    return conversion.toJava(given);
  }

  private UVar variable(UrbiObject given) {
    if (given instanceof UrbiUVar found) {
      return new UVar(context.variables().handOut(found));
    }
    if (given instanceof UrbiString name) {
      return new UVar(Utf8Text.toJava(name.value()));
    }
    throw new ConversionFailure(given, "UVar", Problem.CAST_TO_UVAR.text());
  }

  private @Nullable Object cast(Type type, UrbiObject given) {
    if (type instanceof Class<?> raw && UObject.class.isAssignableFrom(raw)) {
      Instance instance = context.objects().nearest(given);
      if (instance != null && raw.isInstance(instance.java())) {
        return instance.java();
      }
      throw new ConversionFailure(given, raw.getSimpleName(), null);
    }
    try {
      return UCast.to(conversion.toJava(given), type);
    } catch (UCastException e) {
      String name = ArgumentTypes.name(type);
      throw new ConversionFailure(given, name, name == null ? e.getMessage() : null);
    }
  }

  // ------------------------------------------------------------------ results

  private UrbiObject ofNumber(double result) {
    return values.number(result);
  }

  private UrbiObject ofTruth(boolean result) {
    return values.bool(result);
  }

  private UrbiObject ofText(@Nullable String result) {
    return result == null ? values.voidObject : values.string(Utf8Text.toUrbi(result));
  }

  /** A result that may be computed later (a future). */
  private UrbiObject waited(@Nullable Object result) {
    return result(
        result instanceof CompletionStage<?> stage
            ? context.crossing().inKernel(frame -> context.jobs().await(frame, stage))
            : result);
  }

  /** The value of urbiscript for an object of Java. */
  UrbiObject result(@Nullable Object result) {
    return switch (result) {
      case null -> values.voidObject;
      case Boolean truth -> values.bool(truth);
      case Number number -> values.number(number.doubleValue());
      case String text -> ofText(text);
      case UrbiObject object -> object;
      case UVar variable ->
          context
              .crossing()
              .fromKernel(frame -> context.variables().find(frame, variable.getName()));
      default -> conversion.toUrbi(UCast.toUValue(result));
    };
  }
}
