package org.urbi.kernel.library.lobby;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.job.Steps;
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
    if (isReadable(frame, value)) {
      ChannelType.send(frame, self, value);
    } else {
      ChannelType.echo(frame, self, value);
    }
  }

  private static boolean isReadable(Frame frame, UrbiObject value) {
    return isReadable(frame, value, Collections.newSetFromMap(new IdentityHashMap<>()));
  }

  /**
   * A container inside itself cannot be serialized, so it is sent as a plain message. One that is
   * in many others is looked at in each of them, which may take longer than anybody waits.
   */
  private static boolean isReadable(Frame frame, UrbiObject value, Set<UrbiObject> around) {
    return switch (value) {
      case UrbiFloat number -> true;
      case UrbiString string -> true;
      case UrbiList list -> around.add(list) && areReadable(frame, list, list.elements(), around);
      case UrbiDictionary dictionary ->
          around.add(dictionary)
              && areReadable(frame, dictionary, content(frame, dictionary), around);
      default ->
          value == value.world().values().nil
              || value == value.world().values().voidObject
              || isBinary(value);
    };
  }

  private static List<UrbiObject> content(Frame frame, UrbiDictionary dictionary) {
    List<UrbiObject> all = new ArrayList<>();
    dictionary
        .entries()
        .forEach((key, value) -> {
          frame.job().worked(Steps.OBJECT);
          all.add(key.value());
          all.add(value);
        });
    return all;
  }

  private static boolean areReadable(
      Frame frame, UrbiObject container, List<UrbiObject> members, Set<UrbiObject> around) {
    frame.job().worked(Steps.OBJECT);
    for (UrbiObject member : members) {
      frame.job().worked(1);
      if (!isReadable(frame, member, around)) {
        return false;
      }
    }
    around.remove(container);
    return true;
  }

  private static boolean isBinary(UrbiObject value) {
    UrbiObject binary = value.world().prototype("Binary");
    return binary != null && value.isA(binary);
  }
}
