package urbi;

import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import org.jspecify.annotations.Nullable;

/**
 * A record or class that travels by value: a dictionary of its fields, and its name under {@code
 * $sn} (manual, "Casting simple structures").
 */
final class UStruct {
  /** The key under which the name of the structure is. */
  static final String NAME = "$sn";

  private final Class<?> type;
  private final String[] names;
  private final Type[] types;
  private final Reader[] readers;
  private final Maker maker;

  private interface Reader {
    Object read(Object instance) throws ReflectiveOperationException;
  }

  private interface Maker {
    Object make(Object[] fields) throws ReflectiveOperationException;
  }

  private UStruct(Class<?> type, String[] names, Type[] types, Reader[] readers, Maker maker) {
    this.type = type;
    this.names = names;
    this.types = types;
    this.readers = readers;
    this.maker = maker;
  }

  static UStruct ofRecord(Class<?> type) {
    RecordComponent[] components = type.getRecordComponents();
    String[] names = new String[components.length];
    Type[] types = new Type[components.length];
    Class<?>[] raw = new Class<?>[components.length];
    Reader[] readers = new Reader[components.length];
    for (int i = 0; i < components.length; i++) {
      names[i] = components[i].getName();
      types[i] = components[i].getGenericType();
      raw[i] = components[i].getType();
      Method accessor = components[i].getAccessor();
      accessor.setAccessible(true);
      readers[i] = accessor::invoke;
    }
    try {
      Constructor<?> constructor = type.getDeclaredConstructor(raw);
      constructor.setAccessible(true);
      return new UStruct(type, names, types, readers, constructor::newInstance);
    } catch (NoSuchMethodException e) {
      throw new IllegalStateException("a record has its constructor: " + type, e);
    }
  }

  static UStruct ofClass(Class<?> type, String... names) {
    Type[] types = new Type[names.length];
    Reader[] readers = new Reader[names.length];
    Field[] fields = new Field[names.length];
    for (int i = 0; i < names.length; i++) {
      Field field = field(type, names[i]);
      fields[i] = field;
      types[i] = field.getGenericType();
      readers[i] = field::get;
    }
    Constructor<?> constructor;
    try {
      constructor = type.getDeclaredConstructor();
      constructor.setAccessible(true);
    } catch (NoSuchMethodException e) {
      throw new IllegalArgumentException(
          type.getName() + " has no constructor without parameters", e);
    }
    return new UStruct(
        type,
        names.clone(),
        types,
        readers,
        values -> {
          Object instance = constructor.newInstance();
          for (int i = 0; i < values.length; i++) {
            if (values[i] != null || !fields[i].getType().isPrimitive()) {
              fields[i].set(instance, values[i]);
            }
          }
          return instance;
        });
  }

  private static Field field(Class<?> type, String name) {
    for (Class<?> each = type; each != null; each = each.getSuperclass()) {
      for (Field field : each.getDeclaredFields()) {
        if (field.getName().equals(name) && !Modifier.isStatic(field.getModifiers())) {
          field.setAccessible(true);
          return field;
        }
      }
    }
    throw new IllegalArgumentException(type.getName() + " has no field " + name);
  }

  UValue toUValue(Object instance) {
    UDictionary dictionary = new UDictionary();
    dictionary.put(NAME, new UValue(type.getSimpleName()));
    try {
      for (int i = 0; i < names.length; i++) {
        dictionary.put(names[i], UCast.toUValue(readers[i].read(instance)));
      }
    } catch (ReflectiveOperationException e) {
      throw new UCastException("cannot read a " + type.getName() + ": " + cause(e), e);
    }
    return new UValue(dictionary);
  }

  Object fromUValue(UValue value) {
    if (value.getType() != UDataType.DATA_DICTIONARY) {
      throw UCastException.to(type.getSimpleName(), value);
    }
    UDictionary dictionary = value.udictionaryValue();
    Object[] fields = new Object[names.length];
    for (int i = 0; i < names.length; i++) {
      UValue field = dictionary.get(names[i]);
      if (field == null) {
        throw new UCastException(
            "a " + type.getSimpleName() + " is missing field " + names[i] + ": " + value.brief());
      }
      fields[i] = UCast.to(field, types[i]);
    }
    try {
      return maker.make(fields);
    } catch (ReflectiveOperationException e) {
      throw new UCastException("cannot make a " + type.getName() + ": " + cause(e), e);
    }
  }

  private static @Nullable Throwable cause(ReflectiveOperationException e) {
    return e instanceof InvocationTargetException invocation ? invocation.getCause() : e;
  }
}
