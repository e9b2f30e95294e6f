package urbi.spi;

import java.lang.reflect.Type;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UImage;
import urbi.UList;
import urbi.USound;

/** The urbiscript names of Java parameter types, for error messages. */
public final class ArgumentTypes {
  private static final String NUMBER = "Float";

  private static final Map<Class<?>, String> NAMES =
      Map.ofEntries(
          Map.entry(String.class, "String"),
          Map.entry(UList.class, "List"),
          Map.entry(UDictionary.class, "Dictionary"),
          Map.entry(UBinary.class, "Binary"),
          Map.entry(UImage.class, "Binary"),
          Map.entry(USound.class, "Binary"),
          Map.entry(boolean.class, "Boolean"),
          Map.entry(Boolean.class, "Boolean"),
          Map.entry(double.class, NUMBER),
          Map.entry(Double.class, NUMBER),
          Map.entry(float.class, NUMBER),
          Map.entry(Float.class, NUMBER),
          Map.entry(long.class, NUMBER),
          Map.entry(Long.class, NUMBER),
          Map.entry(int.class, NUMBER),
          Map.entry(Integer.class, NUMBER),
          Map.entry(short.class, NUMBER),
          Map.entry(Short.class, NUMBER),
          Map.entry(byte.class, NUMBER),
          Map.entry(Byte.class, NUMBER));

  private ArgumentTypes() {}

  /** The type of urbiscript; null if there is none that tells as much. */
  public static @Nullable String name(Type type) {
    return type instanceof Class<?> raw ? NAMES.get(raw) : null;
  }
}
