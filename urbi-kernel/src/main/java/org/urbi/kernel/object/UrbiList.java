package org.urbi.kernel.object;

import static java.util.Objects.requireNonNull;

import java.util.Collection;
import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** A list (manual, "List"). */
public final class UrbiList extends UrbiObject {
  private @Nullable Elements elements;

  /** Makes the elements when somebody looks at them for the first time, or null. */
  private @Nullable Supplier<Elements> later;

  public UrbiList(Shape shape, Collection<? extends UrbiObject> elements) {
    super(shape);
    this.elements = new Elements(elements);
  }

  /** Uses the given elements directly, without a copy. */
  public UrbiList(Shape shape, Elements elements) {
    super(shape);
    this.elements = elements;
  }

  /** A list whose elements are made when somebody looks at them. */
  UrbiList(Shape shape, Supplier<Elements> later) {
    super(shape);
    this.later = later;
  }

  private Elements made() {
    Elements known = elements;
    return known == null ? make() : known;
  }

  private Elements make() {
    Elements first = requireNonNull(later, "what is not there is made later").get();
    elements = first;
    later = null;
    return first;
  }

  /** The elements, to be read. */
  public List<UrbiObject> elements() {
    noteContentRead();
    return made();
  }

  /** The elements, to be modified; call {@link #noteContentChange} when it is done. */
  public Elements modify() {
    return made();
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiList(cloneShape(), (Collection<UrbiObject>) made());
  }
}
