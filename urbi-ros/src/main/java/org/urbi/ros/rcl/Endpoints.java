package org.urbi.ros.rcl;

import java.lang.foreign.Arena;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;

/** Who publishes a topic, or subscribes to it. */
final class Endpoints {
  private static final long SIZE = 168;
  private static final long NODE = 0;
  private static final long NAMESPACE = 8;
  private static final long TYPE = 16;
  private static final long GID = 64;
  private static final long GID_SIZE = 16;
  private static final long QOS = 80;
  private static final String NOT_TOLD_YET = "_NODE_NAME_UNKNOWN_";
  private static final String NEVER_TOLD = "_CREATED_BY_BARE_DDS_APP_";

  private Endpoints() {}

  /**
   * One of them.
   *
   * @param id what no other one has
   * @param node the full name of its node; empty if that was not told yet
   * @param type as ROS 2 writes it
   */
  record Endpoint(String id, String node, String type, Delivery.Offer offer) {}

  /** The publishers of a topic. */
  static List<Endpoint> publishers(Session session, String topic) {
    return read(session, "rcl_get_publishers_info_by_topic", topic);
  }

  /** The subscribers of a topic. */
  static List<Endpoint> subscriptions(Session session, String topic) {
    return read(session, "rcl_get_subscriptions_info_by_topic", topic);
  }

  private static List<Endpoint> read(Session session, String function, String topic) {
    return session.use(() -> told(session, function, topic));
  }

  private static List<Endpoint> told(Session session, String function, String topic) {
    CFunctions c = session.functions();
    try (Arena here = Arena.ofConfined()) {
      MemorySegment array = here.allocate(2 * Long.BYTES, Long.BYTES);
      c.check(function, session.node(), session.allocator(), topic, false, array);
      long count = array.get(ValueLayout.JAVA_LONG, 0);
      List<Endpoint> all = new ArrayList<>();
      MemorySegment first = CFunctions.content(array, Long.BYTES, count * SIZE);
      for (long i = 0; i < count; i++) all.add(endpoint(first.asSlice(i * SIZE, SIZE)));
      c.check("rmw_topic_endpoint_info_array_fini", array, session.allocator());
      return all;
    }
  }

  private static Endpoint endpoint(MemorySegment info) {
    byte[] gid = info.asSlice(GID, GID_SIZE).toArray(ValueLayout.JAVA_BYTE);
    String id = HexFormat.of().formatHex(gid);
    String name = text(info, NODE);
    return new Endpoint(
        id,
        switch (name) {
          case NOT_TOLD_YET -> "";
          case NEVER_TOLD -> id;
          default -> NodeGraph.fullName(text(info, NAMESPACE), name);
        },
        text(info, TYPE),
        Delivery.Offer.of(info.asSlice(QOS)));
  }

  private static String text(MemorySegment info, long at) {
    return CFunctions.text(info.get(ValueLayout.ADDRESS, at));
  }
}
