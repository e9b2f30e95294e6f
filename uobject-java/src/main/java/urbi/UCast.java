package urbi;

import java.lang.reflect.Array;
import java.lang.reflect.GenericArrayType;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.lang.reflect.WildcardType;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * Makes values of Java objects and Java objects of values: arguments and results of functions, and
 * what variables hold (manual, "Extending the cast system").
 *
 * <p>Known are numbers, Booleans, characters, strings, enumerations, the types of this package,
 * arrays, collections, maps, {@link Optional}, records, and the types that were registered.
 */
public final class UCast {
  /** What was registered for a class; it lives as long as the class does. */
  private static final ClassValue<Registration> REGISTERED =
      new ClassValue<>() {
        @Override
        protected Registration computeValue(Class<?> type) {
          return new Registration();
        }
      };

  private static final class Registration {
    volatile @Nullable Caster caster;
  }

  private record Caster(Function<Object, UValue> toUValue, Function<UValue, Object> fromUValue) {}

  static {
    register(UVector.class, UVector::toUValue, UVector::of);
    register(UMatrix.class, UMatrix::toUValue, UMatrix::of);
  }

  private UCast() {}

  /**
   * Tells how objects of a type become values and values such objects.
   *
   * @param fromUValue may throw anything for a value that does not fit; best a {@link
   *     UCastException}
   */
  public static <T> void register(
      Class<T> type,
      Function<? super T, UValue> toUValue,
      Function<UValue, ? extends T> fromUValue) {
    REGISTERED.get(type).caster =
        new Caster(object -> toUValue.apply(type.cast(object)), fromUValue::apply);
  }

  /**
   * Tells which fields of a class make it a structure, by value, on both sides (manual, "Casting
   * simple structures"). In urbiscript a class of the same simple name inherits from
   * UValueSerializable and is in Serializables. Records need no such call.
   *
   * @param type has a constructor without parameters
   * @throws IllegalArgumentException if it has none, or not such a field
   */
  public static void registerStruct(Class<?> type, String... fields) {
    UStruct struct = UStruct.ofClass(type, fields);
    REGISTERED.get(type).caster = new Caster(struct::toUValue, struct::fromUValue);
  }

  private static @Nullable Caster casterOf(Class<?> type) {
    Registration registration = REGISTERED.get(type);
    Caster caster = registration.caster;
    if (caster == null && type.isRecord()) {
      UStruct struct = UStruct.ofRecord(type);
      caster = new Caster(struct::toUValue, struct::fromUValue);
      registration.caster = caster;
    }
    return caster;
  }

  /**
   * The value that stands for an object; nothing for null.
   *
   * @throws UCastException if the type of the object is not known
   */
  public static UValue toUValue(@Nullable Object object) {
    return switch (object) {
      case null -> new UValue();
      case UValue value -> value;
      case Number number -> new UValue(number.doubleValue());
      case Boolean bool -> new UValue((boolean) bool);
      case String string -> new UValue(string);
      case Character character -> new UValue((char) character);
      case UList list -> new UValue(list);
      case UDictionary dictionary -> new UValue(dictionary);
      case UBinary binary -> new UValue(binary);
      case UImage image -> new UValue(image);
      case USound sound -> new UValue(sound);
      case byte[] bytes -> new UValue(new UBinary(bytes));
      case UVar variable -> UValue.slotName(variable.getName());
      case UObject uobject -> UValue.slotName(uobject.get__name());
      default -> other(object);
    };
  }

  private static UValue other(Object object) {
    Caster caster = casterOf(object.getClass());
    if (caster != null) {
      return caster.toUValue.apply(object);
    }
    return switch (object) {
      case Enum<?> constant -> new UValue(constant.name());
      case Collection<?> collection -> new UValue(new UList(collection));
      case Map<?, ?> map -> new UValue(new UDictionary(map));
      case Optional<?> optional -> toUValue(optional.orElse(null));
      case CharSequence text -> new UValue(text.toString());
      default -> array(object);
    };
  }

  private static UValue array(Object object) {
    if (!object.getClass().isArray()) {
      throw new UCastException("no value stands for a " + object.getClass().getName());
    }
    UList list = new UList();
    for (int i = 0; i < Array.getLength(object); i++) {
      list.add(toUValue(Array.get(object, i)));
    }
    return new UValue(list);
  }

  /**
   * A value as an instance of a type.
   *
   * @throws UCastException if it is not one
   */
  // What toClass returns is of that class, boxed where T is the wrapper of a primitive type.
  @SuppressWarnings("unchecked")
  public static <T> @Nullable T to(UValue value, Class<T> type) {
    return (T) toClass(value, type);
  }

  /**
   * A value as an instance of a type with parameters, as of a method's parameter.
   *
   * @throws UCastException if it is not one
   */
  public static @Nullable Object to(UValue value, Type type) {
    return switch (type) {
      case Class<?> plain -> toClass(value, plain);
      case ParameterizedType generic -> toGeneric(value, generic);
      case GenericArrayType array -> toArray(value, array.getGenericComponentType());
      case WildcardType wildcard -> to(value, wildcard.getUpperBounds()[0]);
      default -> toClass(value, Object.class);
    };
  }

  private static @Nullable Object toClass(UValue value, Class<?> type) {
    if (type == UValue.class) {
      return value;
    }
    if (type == double.class || type == Double.class || type == Number.class) {
      return value.doubleValue();
    }
    if (type == int.class || type == Integer.class) {
      return value.intValue();
    }
    if (type == String.class || type == CharSequence.class) {
      return value.stringValue();
    }
    if (type == boolean.class || type == Boolean.class) {
      return value.booleanValue();
    }
    if (type == long.class || type == Long.class) {
      return value.longValue();
    }
    if (type == float.class || type == Float.class) {
      return value.floatValue();
    }
    if (type == short.class || type == Short.class) {
      return (short) value.intValue();
    }
    if (type == byte.class || type == Byte.class) {
      return (byte) value.intValue();
    }
    if (type == char.class || type == Character.class) {
      return character(value);
    }
    if (type == void.class || type == Void.class) {
      return null;
    }
    return toReference(value, type);
  }

  static char character(UValue value) {
    if (value.getType() == UDataType.DATA_DOUBLE) {
      return (char) value.intValue();
    }
    String text = value.stringValue();
    if (text.length() != 1) {
      throw UCastException.to("char", value);
    }
    return text.charAt(0);
  }

  private static @Nullable Object toReference(UValue value, Class<?> type) {
    if (type == UList.class) {
      return value.ulistValue();
    }
    if (type == UDictionary.class) {
      return value.udictionaryValue();
    }
    if (type == UBinary.class) {
      return value.ubinaryValue();
    }
    if (type == UImage.class) {
      return value.uimageValue();
    }
    if (type == USound.class) {
      return value.usoundValue();
    }
    if (type == byte[].class && value.getType() == UDataType.DATA_BINARY) {
      return value.ubinaryValue().getData();
    }
    if (type == UVar.class) {
      return variable(value);
    }
    if (UObject.class.isAssignableFrom(type)) {
      return object(value, type);
    }
    Caster caster = casterOf(type);
    if (caster != null) {
      return cast(value, type, caster);
    }
    if (type.isEnum()) {
      return constant(value, type);
    }
    if (type.isArray()) {
      return toArray(value, type.getComponentType());
    }
    if (type == Object.class) {
      return plain(value);
    }
    if (type.isAssignableFrom(Map.class) && value.getType() == UDataType.DATA_DICTIONARY) {
      return map(value, Object.class);
    }
    if (type == Set.class) {
      return new LinkedHashSet<>(list(value, Object.class));
    }
    if (type.isAssignableFrom(List.class)) {
      return list(value, Object.class);
    }
    throw UCastException.to(type.getSimpleName(), value);
  }

  private static UVar variable(UValue value) {
    if (value.getType() != UDataType.DATA_STRING && value.getType() != UDataType.DATA_SLOTNAME) {
      throw new UCastException("invalid cast to UVar from non-string value.");
    }
    return new UVar(value.stringValue());
  }

  private static Object object(UValue value, Class<?> type) {
    if (value.getType() == UDataType.DATA_STRING || value.getType() == UDataType.DATA_SLOTNAME) {
      UObject found = UContext.current().getUObject(value.stringValue());
      if (type.isInstance(found)) {
        return found;
      }
    }
    throw UCastException.to(type.getSimpleName(), value);
  }

  private static Object cast(UValue value, Class<?> type, Caster caster) {
    try {
      return caster.fromUValue.apply(value);
    } catch (UCastException e) {
      throw e;
    } catch (RuntimeException e) {
      throw new UCastException(
          "invalid cast to " + type.getSimpleName() + " from " + value.brief() + ": " + e, e);
    }
  }

  private static Object constant(UValue value, Class<?> type) {
    for (Object constant : type.getEnumConstants()) {
      if (((Enum<?>) constant).name().equals(value.stringValue())) {
        return constant;
      }
    }
    throw UCastException.to(type.getSimpleName(), value);
  }

  /** What Java would take for it: a number, a string, a list, a map, or null. */
  private static @Nullable Object plain(UValue value) {
    return switch (value.getType()) {
      case DATA_VOID -> null;
      case DATA_DOUBLE -> value.doubleValue();
      case DATA_STRING, DATA_SLOTNAME -> value.stringValue();
      case DATA_BINARY -> value.ubinaryValue();
      case DATA_LIST -> list(value, Object.class);
      case DATA_DICTIONARY -> map(value, Object.class);
    };
  }

  private static @Nullable Object toGeneric(UValue value, ParameterizedType type) {
    Class<?> raw = (Class<?>) type.getRawType();
    Type last = type.getActualTypeArguments()[type.getActualTypeArguments().length - 1];
    if (raw == Optional.class) {
      return value.isVoid() ? Optional.empty() : Optional.ofNullable(to(value, last));
    }
    if (raw == Map.class || raw == LinkedHashMap.class) {
      return map(value, last);
    }
    if (raw == Set.class || raw == LinkedHashSet.class) {
      return new LinkedHashSet<>(list(value, last));
    }
    if (raw.isAssignableFrom(ArrayList.class)) {
      return list(value, last);
    }
    return toClass(value, raw);
  }

  private static List<Object> list(UValue value, Type element) {
    UList values = value.ulistValue();
    List<Object> list = new ArrayList<>(values.size());
    for (UValue each : values) {
      list.add(to(each, element));
    }
    return list;
  }

  private static Map<String, Object> map(UValue value, Type element) {
    Map<String, Object> map = new LinkedHashMap<>();
    value.udictionaryValue().forEach((name, each) -> map.put(name, to(each, element)));
    return map;
  }

  private static Object toArray(UValue value, Type element) {
    List<Object> values = list(value, element);
    Class<?> raw =
        switch (element) {
          case Class<?> plain -> plain;
          case ParameterizedType generic -> (Class<?>) generic.getRawType();
          default -> Object.class;
        };
    Object array = Array.newInstance(raw, values.size());
    for (int i = 0; i < values.size(); i++) {
      Array.set(array, i, values.get(i));
    }
    return array;
  }
}
