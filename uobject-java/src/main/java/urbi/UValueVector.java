package urbi;

import java.util.ArrayList;
import java.util.Collection;

/** Values one after the other, as {@link UList} keeps them. */
public final class UValueVector extends ArrayList<UValue> {
  private static final long serialVersionUID = 1;

  public UValueVector() {}

  /** So many values, each of them nothing. */
  public UValueVector(long size) {
    super(Math.toIntExact(size));
    for (long i = 0; i < size; i++) {
      add(new UValue());
    }
  }

  public UValueVector(Collection<? extends UValue> values) {
    super(values);
  }

  /** Has room for so many values without growing. */
  public void reserve(long size) {
    ensureCapacity(Math.toIntExact(size));
  }
}
