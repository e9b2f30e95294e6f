package org.urbi.kernel.library.object;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.library.lobby.LobbyType;
import org.urbi.kernel.library.lobby.Warnings;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** Descriptions of objects (manual, "Object": {@code inspect}, {@code dump}). */
@UrbiTypePart(value = "Object", needs = Permission.NOTHING)
final class ObjectDescription {
  private ObjectDescription() {}

  private static void say(Frame frame, String line) {
    LobbyType.output(frame).send("", "*** " + line);
  }

  private static List<Symbol> slots(Frame frame, UrbiObject object) {
    List<Symbol> names = new ArrayList<>(Arrays.asList(object.localSlotNames()));
    names.sort((one, other) -> {
      frame.job().worked(1 + Steps.ofCharacters(one.name().length()));
      return one.name().compareTo(other.name());
    });
    return names;
  }

  /** The properties set by programs, by name. */
  private static Map<String, UrbiObject> properties(UrbiObject object, Symbol slot) {
    SlotData data = object.slotData(slot);
    return data == null ? Map.of() : data.properties();
  }

  @Builtin(doc = "Sends the object to the channel topLevel.")
  static void print(Frame frame, UrbiObject self) {
    UrbiObject topLevel = OwnSlots.get(frame, LobbyType.of(frame), "topLevel");
    frame.interpreter().send(frame, topLevel, "<<", self);
  }

  // ------------------------------------------------------------------ inspect

  @Builtin(doc = "Shows the prototypes and the slots; also the inherited ones when deep.")
  static void inspect(Frame frame, UrbiObject self, @Optional @Nullable UrbiObject deep) {
    say(frame, "Inspecting " + frame.interpreter().asPrintable(frame, self));
    say(frame, "** Prototypes:");
    for (UrbiObject proto : self.protos()) {
      say(frame, "  " + frame.interpreter().asPrintable(frame, proto));
    }
    say(frame, "** Local Slots:");
    listSlots(frame, self);
    if (deep != null && Truth.of(frame, deep)) {
      for (UrbiObject ancestor : ObjectType.allProtos(self)) {
        if (ancestor != self) {
          say(frame, "** Slots from " + frame.interpreter().asPrintable(frame, ancestor) + ":");
          listSlots(frame, ancestor);
        }
      }
    }
  }

  private static void listSlots(Frame frame, UrbiObject object) {
    for (Symbol name : slots(frame, object)) {
      frame.job().worked(Steps.OBJECT);
      say(frame, "  " + name.name() + " : " + typeOf(frame, object.existingSlot(name)));
      Map<String, UrbiObject> properties = properties(object, name);
      if (!properties.isEmpty()) {
        say(frame, "    Properties:");
        properties.forEach((property, value) ->
            say(
                frame,
                "     "
                    + property
                    + " : "
                    + typeOf(frame, value)
                    + " = "
                    + frame.interpreter().asPrintable(frame, value)));
      }
    }
  }

  private static String typeOf(Frame frame, UrbiObject value) {
    if (value == frame.interpreter().values().voidObject) {
      return "void";
    }
    UrbiObject type = value.lookup(frame.interpreter().symbols().type);
    if (type instanceof Code) {
      type = frame.interpreter().call(frame, type, value);
    }
    return type instanceof UrbiString name ? name.value() : "Object";
  }

  // ------------------------------------------------------------------ dump

  @Builtin(doc = "Shows prototypes, slots and properties, those of slots as deep as said.")
  static void dump(Frame frame, UrbiObject self, int depth) {
    say(frame, identity(frame, self) + " {");
    new Dump(frame, self).content(self, depth, "  ");
  }

  /** The type and the address, whatever the value. */
  private static String identity(Frame frame, UrbiObject object) {
    return typeOf(frame, object) + "_" + ObjectType.uid(object);
  }

  /** One dump; what is within itself, or in several places, is shown once. */
  private static final class Dump {
    private final Frame frame;
    private final Set<UrbiObject> shown = Collections.newSetFromMap(new IdentityHashMap<>());

    Dump(Frame frame, UrbiObject first) {
      this.frame = frame;
      shown.add(first);
    }

    void content(UrbiObject object, int depth, String indent) {
      say(frame, indent + "/* Special slots */");
      say(
          frame,
          indent
              + "protos = "
              + Arrays.stream(object.protos())
                  .map(proto ->
                      proto.localSlot(frame.interpreter().symbols().type) == null
                          ? identity(frame, proto)
                          : typeOf(frame, proto))
                  .collect(Collectors.joining(", ")));
      if (object instanceof UrbiFloat number) {
        UrbiObject plain = frame.interpreter().values().number(number.value());
        say(frame, indent + "value = " + frame.interpreter().asString(frame, plain));
      }
      say(frame, indent + "/* Slots */");
      for (Symbol name : slots(frame, object)) {
        value(name.name(), object.existingSlot(name), depth, indent);
        Map<String, UrbiObject> properties = properties(object, name);
        if (!properties.isEmpty()) {
          say(frame, indent + "  /* Properties */");
          properties.forEach((property, value) -> value(property, value, depth, indent + "  "));
        }
      }
      say(frame, indent + "}");
    }

    private void value(String name, UrbiObject value, int depth, String indent) {
      frame.job().checkInterrupted();
      if (depth <= 0 || !shown.add(value)) {
        say(frame, indent + name + " = " + identity(frame, value) + " <...>");
      } else {
        say(frame, indent + name + " = " + identity(frame, value) + " {");
        content(value, depth - 1, indent + "  ");
      }
    }
  }

  // ------------------------------------------------------------------ and the rest

  @Builtin(
      value = {"$id"},
      doc = "The type and the identifier of the object.")
  static String id(Frame frame, UrbiObject self) {
    return identity(frame, self);
  }

  @Builtin(doc = "Deprecated: the period of the system.")
  static UrbiObject getPeriod(Frame frame, CallSite site, UrbiObject self) {
    Warnings.deprecated(frame, site, "getPeriod", "System.period");
    return OwnSlots.get(frame, self.world().prototype("System"), "period");
  }
}
