package org.urbi.kernel.uobject;

import org.urbi.kernel.error.Problem;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import urbi.UCastException;
import urbi.UDictionary;
import urbi.UValue;

/**
 * Objects that travel by value: classes of urbiscript which inherit from {@code UValueSerializable}
 * and are slots of {@code Serializables} (manual, "Casting simple structures").
 */
final class Structures {
  /** The key of the structure's name. */
  static final String NAME = "$sn";

  private final PluggedContext context;
  private final KernelCrossing crossing;
  private final ValueConversion values;

  Structures(PluggedContext context, ValueConversion values) {
    this.context = context;
    this.crossing = context.crossing();
    this.values = values;
  }

  private UrbiObject prototype(String type) {
    return context.interpreter().world().prototype(type);
  }

  boolean isStructure(UrbiObject object) {
    return object.isA(prototype("UValueSerializable"));
  }

  /** The fields are the slots of the class. */
  UDictionary toJava(UrbiObject object, int depth) {
    UrbiObject type = type(object);
    return crossing.fromKernel(frame -> {
      UDictionary fields = new UDictionary();
      fields.with(
          NAME, Utf8Text.toJava(frame.interpreter().asString(frame, typeName(frame, type))));
      for (Symbol slot : type.localSlotNames()) {
        if (isField(type, slot)) {
          UrbiObject value = frame.interpreter().get(frame, object, slot);
          fields.put(Utf8Text.toJava(slot.name()), values.toJava(value, depth + 1));
        }
      }
      return fields;
    });
  }

  private static UrbiObject typeName(Frame frame, UrbiObject type) {
    return frame.interpreter().get(frame, type, frame.interpreter().world().symbol("type"));
  }

  /** The nearest ancestor which has a name; the object itself may be one. */
  private UrbiObject type(UrbiObject object) {
    UrbiObject type = object.locate(context.interpreter().world().symbol("type"));
    return type == null ? object : type;
  }

  /** Whether a slot of a class is data: neither a function nor a slot that every class has. */
  private static boolean isField(UrbiObject type, Symbol slot) {
    UrbiObject value = type.localSlot(slot);
    return !(value instanceof Code) && !slot.name().equals("type");
  }

  /** A new object of the class of that name, with these fields. */
  UrbiObject toUrbi(String name, UDictionary fields) {
    return crossing.fromKernel(frame -> {
      UrbiObject registered =
          prototype("Serializables").localSlot(frame.interpreter().world().symbol(name));
      if (registered == null) {
        throw new UCastException(Problem.NO_SERIALIZABLE.text(name));
      }
      UrbiObject made = frame.interpreter().send(frame, registered, "new");
      fields.forEach((field, value) -> {
        if (!field.equals(NAME)) {
          set(frame, made, field, value);
        }
      });
      return made;
    });
  }

  private void set(Frame frame, UrbiObject made, String field, UValue value) {
    Symbol slot = frame.interpreter().world().symbol(Utf8Text.toUrbi(field));
    SlotUpdate.assign(frame, made, slot, values.element(value));
  }
}
