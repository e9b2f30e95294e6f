package org.urbi.kernel.object;

import java.util.Collection;
import java.util.List;

/** A list (manual, "List"). */
public final class UrbiList extends UrbiObject {
  private final Elements elements;

  public UrbiList(Shape shape, Collection<? extends UrbiObject> elements) {
    super(shape);
    this.elements = new Elements(elements);
  }

  /** Uses the given elements directly, without a copy. */
  public UrbiList(Shape shape, Elements elements) {
    super(shape);
    this.elements = elements;
  }

  /** The elements, to be read. */
  public List<UrbiObject> elements() {
    noteContentRead();
    return elements;
  }

  /** The elements, to be modified; call {@link #noteContentChange} when it is done. */
  public Elements modify() {
    return elements;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiList(cloneShape(), (Collection<UrbiObject>) elements);
  }
}
