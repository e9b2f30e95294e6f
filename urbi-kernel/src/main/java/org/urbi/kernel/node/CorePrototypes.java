package org.urbi.kernel.node;

import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;

/** The prototypes of objects that the interpreter creates, other than everyday values. */
public final class CorePrototypes {
  public final UrbiObject executable;
  public final UrbiObject code;
  public final UrbiObject primitive;
  public final UrbiObject lazy;
  public final UrbiObject callMessage;
  public final UrbiObject enumeration;
  public final UrbiObject event;
  public final UrbiObject tag;
  final Shape codeShape;
  final Shape primitiveShape;

  /** The function {@code asType} of types: returns its target. */
  final UrbiObject asThis;

  /** The object below which implicit tags are created. */
  public final UrbiObject tags;

  /**
   * @param event the prototype of events
   * @param tag the prototype of tags
   */
  public CorePrototypes(Values values, UrbiObject event, UrbiObject tag) {
    executable = values.object.cloned();
    code = executable.cloned();
    primitive = executable.cloned();
    lazy = values.object.cloned();
    callMessage = values.object.cloned();
    enumeration = values.object.cloned();
    this.event = event;
    this.tag = tag;
    tags = values.object.cloned();
    asThis = new IdentityCode(code);
    codeShape = code.cloneShape();
    primitiveShape = primitive.cloneShape();
  }

  /** The shape of fresh primitives. */
  public Shape primitiveShape() {
    return primitiveShape;
  }
}
