package org.urbi.kernel.library.lobby;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** Channels for clients that read only some types (manual, "Channel", {@code Filter}). */
@UrbiType(
    value = "Channel.Filter",
    protos = {"Channel"},
    doc = "A channel that sends what the client library cannot read as messages.",
    needs = Permission.NOTHING)
final class ChannelFilterType {
  private ChannelFilterType() {}

  @Builtin(
      value = {"<<"},
      doc = "Sends a value; as a message when the client library cannot read it.")
  static void send(Frame frame, UrbiObject self, UrbiObject value) {
    if (isReadable(value)) {
      ChannelType.send(frame, self, value);
    } else {
      ChannelType.echo(frame, self, value);
    }
  }

  private static boolean isReadable(UrbiObject value) {
    return isReadable(value, Collections.newSetFromMap(new IdentityHashMap<>()));
  }

  /** A container inside itself cannot be serialized, so it is sent as a plain message. */
  private static boolean isReadable(UrbiObject value, Set<UrbiObject> around) {
    return switch (value) {
      case UrbiFloat number -> true;
      case UrbiString string -> true;
      case UrbiList list -> around.add(list) && areReadable(list, list.elements(), around);
      case UrbiDictionary dictionary -> {
        List<UrbiObject> all = new ArrayList<>(dictionary.entries().values());
        dictionary.entries().keySet().forEach(key -> all.add(key.value()));
        yield around.add(dictionary) && areReadable(dictionary, all, around);
      }
      default ->
          value == value.world().values().nil
              || value == value.world().values().voidObject
              || isBinary(value);
    };
  }

  private static boolean areReadable(
      UrbiObject container, List<UrbiObject> members, Set<UrbiObject> around) {
    boolean readable = members.stream().allMatch(member -> isReadable(member, around));
    around.remove(container);
    return readable;
  }

  private static boolean isBinary(UrbiObject value) {
    UrbiObject binary = value.world().prototype("Binary");
    return binary != null && value.isA(binary);
  }
}
