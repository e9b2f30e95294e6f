package org.urbi.kernel.script;

import java.util.AbstractMap;
import java.util.AbstractSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.script.Bindings;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.embed.UrbiValue;

/**
 * The slots of an object as the variables of an engine: a change by one side is visible to the
 * other.
 */
final class SlotBindings extends AbstractMap<String, Object> implements Bindings {
  private final UrbiValue object;

  SlotBindings(UrbiValue object) {
    this.object = object;
  }

  UrbiValue object() {
    return object;
  }

  private static String name(Object key) {
    String name = (String) key;
    if (name.isEmpty()) {
      throw new IllegalArgumentException("a variable without a name");
    }
    return name;
  }

  @Override
  public boolean containsKey(Object key) {
    return object.has(name(key));
  }

  @Override
  public @Nullable Object get(Object key) {
    String name = name(key);
    return object.has(name) ? object.get(name) : null;
  }

  @Override
  public @Nullable Object put(String key, Object value) {
    Object old = get(key);
    object.set(key, value);
    return old;
  }

  @Override
  public @Nullable Object remove(Object key) {
    Object old = get(key);
    object.remove(name(key));
    return old;
  }

  @Override
  public Set<Entry<String, Object>> entrySet() {
    List<String> names = object.slotNames();
    return new AbstractSet<>() {
      @Override
      public int size() {
        return names.size();
      }

      @Override
      public Iterator<Entry<String, Object>> iterator() {
        return new Entries(names.iterator());
      }
    };
  }

  private final class Entries implements Iterator<Map.Entry<String, Object>> {
    private final Iterator<String> names;
    private @Nullable String last;

    Entries(Iterator<String> names) {
      this.names = names;
    }

    @Override
    public boolean hasNext() {
      return names.hasNext();
    }

    @Override
    public Map.Entry<String, Object> next() {
      String name = names.next();
      last = name;
      return new SimpleEntry<>(name, SlotBindings.this.get(name)) {
        private static final long serialVersionUID = 1;

        @Override
        public Object setValue(Object value) {
          object.set(getKey(), value);
          return super.setValue(value);
        }
      };
    }

    @Override
    public void remove() {
      if (last == null) {
        throw new IllegalStateException();
      }
      object.remove(last);
    }
  }
}
