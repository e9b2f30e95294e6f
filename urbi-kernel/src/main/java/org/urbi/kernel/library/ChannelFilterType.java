package org.urbi.kernel.library;

import org.urbi.builtins.Builtin;
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
    doc = "A channel that sends what the client library cannot read as messages.")
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
    return switch (value) {
      case UrbiFloat number -> true;
      case UrbiString string -> true;
      case UrbiList list -> list.elements().stream().allMatch(ChannelFilterType::isReadable);
      case UrbiDictionary dictionary ->
          dictionary.entries().entrySet().stream()
              .allMatch(
                  entry -> isReadable(entry.getKey().value()) && isReadable(entry.getValue()));
      default ->
          value == value.world().values().nil
              || value == value.world().values().voidObject
              || isBinary(value);
    };
  }

  private static boolean isBinary(UrbiObject value) {
    UrbiObject binary = value.world().prototype("Binary");
    return binary != null && value.isA(binary);
  }
}
