package org.urbi.kernel.object;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;

/**
 * The constants of a kernel, and the factory methods of its everyday values: each evaluation of a
 * literal creates a new object.
 */
public final class Values {
  /** {@code Object}, from which everything inherits. */
  public final UrbiObject object;

  public final UrbiFloat floatProto;
  public final UrbiString stringProto;
  public final UrbiList listProto;
  public final UrbiTuple tupleProto;
  public final UrbiDictionary dictionaryProto;
  public final UrbiObject nil;
  public final UrbiObject voidObject;

  /** What {@code void.acceptVoid} returns: void, but it can be passed on. */
  public final UrbiObject acceptedVoid;

  public final UrbiObject booleanProto;
  public final UrbiObject trueObject;
  public final UrbiObject falseObject;
  public final Shape floatShape;

  /** The shape of numbers in slots whose objects nobody has seen. */
  public final Shape unseenShape;

  private final Shape stringShape;
  private final Shape listShape;
  private final Shape tupleShape;
  private final Shape dictionaryShape;

  Values(World world) {
    object = new UrbiObject(world.orphanShape());
    Shape child = object.cloneShape();
    floatProto = new UrbiFloat(child, 0);
    stringProto = new UrbiString(child, "");
    listProto = new UrbiList(child, List.of());
    tupleProto = new UrbiTuple(child, List.of());
    dictionaryProto = new UrbiDictionary(child, Map.of());
    nil = object.cloned();
    voidObject = new UrbiObject(world.orphanShape());
    acceptedVoid = voidObject.cloned();
    booleanProto = object.cloned();
    trueObject = booleanProto.cloned();
    falseObject = booleanProto.cloned();
    floatShape = floatProto.cloneShape();
    unseenShape = floatShape.unseen();
    stringShape = stringProto.cloneShape();
    listShape = listProto.cloneShape();
    tupleShape = tupleProto.cloneShape();
    dictionaryShape = dictionaryProto.cloneShape();
  }

  public UrbiFloat number(double value) {
    return new UrbiFloat(floatShape, value);
  }

  /** A string; each {@code char} is a byte. */
  public UrbiString string(String value) {
    return new UrbiString(stringShape, value);
  }

  /** A new string: the first followed by the second. */
  public UrbiString concatenation(UrbiString first, String second) {
    return first.followedBy(stringShape, second);
  }

  public UrbiObject bool(boolean value) {
    return value ? trueObject : falseObject;
  }

  /** A list with a copy of these elements. */
  public UrbiList list(Collection<? extends UrbiObject> elements) {
    return new UrbiList(listShape, elements);
  }

  /** A list that uses the given elements directly. */
  public UrbiList listOf(Elements elements) {
    return new UrbiList(listShape, elements);
  }

  /** A list whose elements are made when somebody looks at them. */
  public UrbiList listLater(Supplier<Elements> elements) {
    return new UrbiList(listShape, elements);
  }

  public UrbiTuple tuple(List<? extends UrbiObject> elements) {
    return new UrbiTuple(tupleShape, elements);
  }

  public UrbiDictionary dictionary(Map<UrbiDictionary.Key, UrbiObject> entries) {
    return new UrbiDictionary(dictionaryShape, entries);
  }
}
