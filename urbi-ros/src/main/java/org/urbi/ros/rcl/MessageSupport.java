package org.urbi.ros.rcl;

import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.util.HexFormat;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.TypeHash;
import org.urbi.ros.message.TypeName;
import urbi.UDictionary;

/** What an installation knows of a type of messages. */
final class MessageSupport {
  private static final int HASH = 32;

  private final CFunctions c;
  private final String symbol;
  private final MemorySegment handle;
  private final MessageCodec codec;

  private MessageSupport(CFunctions c, MessageType type) {
    this.c = c;
    symbol = symbol(type.name());
    handle = handle(c, "message", type.name());
    codec = MessageCodec.of(type);
  }

  /**
   * What there is of a type.
   *
   * @throws RosException if there is nothing, or another version of it
   */
  static MessageSupport of(Installation installation, MessageType type) {
    installation.loadTypes(type.name().pack());
    MessageSupport support = new MessageSupport(installation.functions(), type);
    support.checkVersion(installation);
    return support;
  }

  /** {@code std_msgs__msg__String}. */
  private static String symbol(TypeName name) {
    return name.toString().replace("/", "__");
  }

  /** What is known of a message, or of a service. */
  static MemorySegment handle(CFunctions c, String kind, TypeName name) {
    return c.pointer("rosidl_typesupport_c__get_" + kind + "_type_support_handle__" + symbol(name));
  }

  private void checkVersion(Installation installation) {
    MemorySegment hash = c.pointer(symbol + "__get_type_hash", handle);
    byte[] bytes = hash.asSlice(1, HASH).toArray(ValueLayout.JAVA_BYTE);
    String theirs =
        "RIHS0" + hash.get(ValueLayout.JAVA_BYTE, 0) + "_" + HexFormat.of().formatHex(bytes);
    if (!theirs.equals(TypeHash.rihs(codec.type())))
      throw new RosException(
          codec.type().name() + " is of another version in " + installation.library());
  }

  MemorySegment handle() {
    return handle;
  }

  MessageType type() {
    return codec.type();
  }

  byte[] encode(UDictionary message) {
    return codec.encode(message);
  }

  UDictionary decode(byte[] bytes) {
    return codec.decode(bytes);
  }

  /** A message as C has it, to be destroyed by whoever has called this. */
  MemorySegment create() {
    MemorySegment made = c.pointer(symbol + "__create");
    if (made.equals(MemorySegment.NULL)) throw new RosException("no memory for " + symbol);
    return made;
  }

  void destroy(MemorySegment message) {
    c.run(symbol + "__destroy", message);
  }

  /** Makes a message of C be that of urbiscript. */
  void write(UDictionary from, MemorySegment to, SerializedBytes bytes) {
    bytes.put(encode(from));
    c.check("rmw_deserialize", bytes.array(), handle, to);
  }

  /** What a message of C says. */
  UDictionary read(MemorySegment message, SerializedBytes bytes) {
    c.check("rmw_serialize", message, handle, bytes.array());
    return decode(bytes.get());
  }
}
