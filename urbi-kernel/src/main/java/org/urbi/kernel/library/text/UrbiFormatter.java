package org.urbi.kernel.library.text;

import java.util.List;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A format string cut in pieces: Strings and FormatInfos (manual, "Formatter"). */
final class UrbiFormatter extends UrbiObject {
  private List<UrbiObject> pieces;

  UrbiFormatter(Shape shape, List<UrbiObject> pieces) {
    super(shape);
    this.pieces = pieces;
  }

  List<UrbiObject> pieces() {
    return pieces;
  }

  void setPieces(List<UrbiObject> others) {
    pieces = others;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiFormatter(cloneShape(), pieces);
  }
}
