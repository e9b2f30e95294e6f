package org.urbi.kernel.object;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A dictionary (manual, "Dictionary"). Keys are compared as {@code ==} and {@code hash} of
 * urbiscript say; {@link Key} stands for a key and does so.
 */
public final class UrbiDictionary extends UrbiObject {
  /** A key, with the equality of its value. */
  public interface Key {
    UrbiObject value();
  }

  private final LinkedHashMap<Key, UrbiObject> entries;

  public UrbiDictionary(Shape shape, Map<Key, UrbiObject> entries) {
    super(shape);
    this.entries = new LinkedHashMap<>(entries);
  }

  /** The entries, to be read. */
  public Map<Key, UrbiObject> entries() {
    noteContentRead();
    return entries;
  }

  /** The entries, to be modified; call {@link #noteContentChange} when it is done. */
  public Map<Key, UrbiObject> modify() {
    return entries;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiDictionary(cloneShape(), entries);
  }
}
