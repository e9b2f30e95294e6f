package org.urbi.ros.two;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.urbi.ros.rtps.Guid;

/**
 * Which nodes a participant has, and which of its writers and readers are theirs: what each
 * participant of ROS 2 tells all others ({@code rmw_dds_common/msg/ParticipantEntitiesInfo}).
 *
 * @param participant whose nodes they are
 */
record Entities(Guid participant, List<NodeEntities> nodes) {
  static final String TOPIC = "ros_discovery_info";
  static final String TYPE = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";

  private static final int GID = 16;
  private static final int MOST = 100_000;

  /**
   * A node.
   *
   * @param namespace {@code /} or {@code /robot}
   */
  record NodeEntities(String namespace, String name, List<Guid> readers, List<Guid> writers) {
    String fullName() {
      return namespace.endsWith("/") ? namespace + name : namespace + "/" + name;
    }
  }

  ByteBuffer encode() {
    int size = 64;
    for (NodeEntities each : nodes) {
      size += 64 + 3 * (each.namespace.length() + each.name.length());
      size += GID * (each.readers.size() + each.writers.size());
    }
    ByteBuffer out = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    out.put(new byte[] {0, 1, 0, 0}).put(participant.bytes()).putInt(nodes.size());
    for (NodeEntities each : nodes) {
      put(out, each.namespace);
      put(out, each.name);
      put(out, each.readers);
      put(out, each.writers);
    }
    return out.flip();
  }

  private static void put(ByteBuffer out, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    align(out);
    out.putInt(bytes.length + 1).put(bytes).put((byte) 0);
  }

  private static void put(ByteBuffer out, List<Guid> guids) {
    align(out);
    out.putInt(guids.size());
    guids.forEach(each -> out.put(each.bytes()));
  }

  /** To four bytes; the header before the message has as many, and changes nothing. */
  private static void align(ByteBuffer buffer) {
    int to = (buffer.position() + 3) / 4 * 4;
    if (to > buffer.limit()) throw new BufferUnderflowException();
    buffer.position(to);
  }

  /**
   * What bytes say.
   *
   * @throws IllegalArgumentException if they are something else
   */
  static Entities decode(ByteBuffer payload) {
    try {
      ByteBuffer in = payload.duplicate();
      in.order((in.getInt() >>> 16 & 1) == 1 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
      Guid participant = guid(in);
      int count = count(in, 16);
      List<NodeEntities> nodes = new ArrayList<>();
      for (int i = 0; i < count; i++)
        nodes.add(new NodeEntities(text(in), text(in), guids(in), guids(in)));
      return new Entities(participant, List.copyOf(nodes));
    } catch (BufferUnderflowException e) {
      throw new IllegalArgumentException("truncated list of nodes", e);
    }
  }

  /**
   * Reads how many elements follow.
   *
   * @param least how many bytes an element has at least: the message must have room for all
   */
  private static int count(ByteBuffer in, int least) {
    align(in);
    int count = in.getInt();
    if (count < 0 || count > MOST || (long) count * least > in.remaining())
      throw new IllegalArgumentException("list of nodes that is longer than its message");
    return count;
  }

  private static Guid guid(ByteBuffer in) {
    byte[] bytes = new byte[GID];
    in.get(bytes);
    return Guid.of(bytes);
  }

  private static List<Guid> guids(ByteBuffer in) {
    int count = count(in, GID);
    List<Guid> guids = new ArrayList<>(count);
    for (int i = 0; i < count; i++) guids.add(guid(in));
    return List.copyOf(guids);
  }

  private static String text(ByteBuffer in) {
    byte[] bytes = new byte[count(in, 1)];
    in.get(bytes);
    int end = bytes.length > 0 && bytes[bytes.length - 1] == 0 ? bytes.length - 1 : bytes.length;
    return new String(bytes, 0, end, StandardCharsets.UTF_8);
  }
}
