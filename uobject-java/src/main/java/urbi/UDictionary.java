package urbi;

import java.util.LinkedHashMap;
import java.util.Map;

/** Values by name, in the order in which the names were first put. */
public final class UDictionary extends LinkedHashMap<String, UValue> {
  private static final long serialVersionUID = 1;

  public UDictionary() {}

  /**
   * The entries of a map, names and values made with {@link String#valueOf(Object)} and {@link
   * UCast#toUValue}.
   */
  public UDictionary(Map<?, ?> entries) {
    entries.forEach((name, value) -> put(String.valueOf(name), UCast.toUValue(value)));
  }

  /** Puts what is made a value by {@link UCast#toUValue}. */
  public UDictionary with(String name, Object value) {
    put(name, UCast.toUValue(value));
    return this;
  }

  /**
   * Puts a value, which {@link UCast#toUValue} makes of the object.
   *
   * @return the value that the name had before
   */
  public UValue put(String name, Object value) {
    return put(name, UCast.toUValue(value));
  }

  /** The dictionary as an urbiscript literal. */
  @Override
  public String toString() {
    return UValueWriter.text(new UValue(this));
  }
}
