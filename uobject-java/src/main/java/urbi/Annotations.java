package urbi;

import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Binds the annotated members of an object. */
final class Annotations {
  private static final ClassValue<List<Binding>> BINDINGS =
      new ClassValue<>() {
        @Override
        protected List<Binding> computeValue(Class<?> type) {
          return find(type);
        }
      };

  /** A member that is bound for each object of a class. */
  @FunctionalInterface
  private interface Binding {
    void bind(UObject object) throws ReflectiveOperationException;
  }

  private Annotations() {}

  static void bind(UObject object) throws ReflectiveOperationException {
    for (Binding binding : BINDINGS.get(object.getClass())) {
      binding.bind(object);
    }
  }

  /** Variables first, the notifications of which may be among the others; superclasses first. */
  private static List<Binding> find(Class<?> type) {
    List<Class<?>> lineage = new ArrayList<>();
    for (Class<?> each = type; each != UObject.class && each != null; each = each.getSuperclass()) {
      lineage.addFirst(each);
    }
    List<Binding> bindings = new ArrayList<>();
    lineage.forEach(each -> fields(each, bindings));
    lineage.forEach(each -> methods(each, bindings));
    return bindings;
  }

  private static void fields(Class<?> type, List<Binding> bindings) {
    for (Field field : type.getDeclaredFields()) {
      UVariable variable = field.getAnnotation(UVariable.class);
      if (variable != null) {
        field.setAccessible(true);
        bindings.add(object -> bind(object, field, variable));
      }
      UEventField event = field.getAnnotation(UEventField.class);
      if (event != null) {
        field.setAccessible(true);
        bindings.add(object -> bind(object, field, event));
      }
    }
  }

  private static void bind(UObject object, Field field, UVariable variable)
      throws IllegalAccessException {
    if (!UVar.class.isAssignableFrom(field.getType())) {
      throw new IllegalArgumentException(field + " is annotated with UVariable, but is no UVar");
    }
    UVar bound = (UVar) field.get(object);
    if (bound == null) {
      bound = field.getType() == InputPort.class ? new InputPort() : new UVar();
      field.set(object, bound);
    }
    if (!bound.isBound()) {
      object.UBindVar(bound, name(variable.value(), field.getName()));
    }
    if (variable.owned()) {
      object.UOwned(bound);
    }
  }

  private static void bind(UObject object, Field field, UEventField annotation)
      throws IllegalAccessException {
    if (field.getType() != UEvent.class) {
      throw new IllegalArgumentException(
          field + " is annotated with UEventField, but is no UEvent");
    }
    UEvent event = (UEvent) field.get(object);
    if (event == null) {
      event = new UEvent();
      field.set(object, event);
    }
    if (!event.isBound()) {
      object.UBindEvent(event, name(annotation.value(), field.getName()));
    }
  }

  private static void methods(Class<?> type, List<Binding> bindings) {
    for (Method method : type.getDeclaredMethods()) {
      if (method.isBridge() || method.isSynthetic()) {
        continue;
      }
      UFunction function = method.getAnnotation(UFunction.class);
      if (function != null) {
        bindings.add(object -> bind(object, method, function));
      }
      OnChange change = method.getAnnotation(OnChange.class);
      if (change != null) {
        LockSpec lock = lock(change.threaded(), change.lock(), change.queue());
        bindings.add(object -> object.notifyChange(object.variable(change.value()), method, lock));
      }
      OnAccess access = method.getAnnotation(OnAccess.class);
      if (access != null) {
        bindings.add(object -> object.notifyAccess(object.variable(access.value()), method));
      }
      Every every = method.getAnnotation(Every.class);
      if (every != null) {
        bindings.add(object -> object.setTimer(every.value(), object, method, every.afterPass()));
      }
    }
  }

  private static void bind(UObject object, Method method, UFunction function) {
    String name = name(function.value(), method.getName());
    LockSpec lock = lock(function.threaded(), function.lock(), function.queue());
    if (lock == null) {
      object.bind(name, Methods.callback(object.get__name() + "." + name, object, method));
    } else {
      object.bindThreaded(object, method, name, lock);
    }
  }

  private static @Nullable LockSpec lock(boolean threaded, LockMode mode, int queue) {
    return threaded || mode != LockMode.LOCK_NONE ? new LockSpec(mode, queue) : null;
  }

  private static String name(String given, String declared) {
    return given.isEmpty() ? declared : given;
  }
}
