package org.urbi.kernel.object;

/** A string as key. Many that share a hash code, as somebody may choose them, have an order. */
record TextKey(String text, UrbiObject value) implements UrbiDictionary.Key, Comparable<TextKey> {
  @Override
  public int compareTo(TextKey other) {
    return text.compareTo(other.text);
  }

  @Override
  public Comparable<?> rank() {
    return text;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof TextKey key && text.equals(key.text);
  }

  @Override
  public int hashCode() {
    return text.hashCode();
  }
}
