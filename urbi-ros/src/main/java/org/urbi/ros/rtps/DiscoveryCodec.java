package org.urbi.ros.rtps;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.urbi.ros.rtps.EndpointQos.Liveliness;

/** Descriptions of participants, writers and readers, as samples of the built-in topics. */
final class DiscoveryCodec {
  private static final int PARAMETERS_BIG = 0x0002;
  private static final int PARAMETERS_LITTLE = 0x0003;
  private static final int UDP_V4 = 1;
  private static final int LOCATORS = 16;
  private static final int PARTITIONS = 64;
  private static final int RELIABLE = 2;
  private static final long DEFAULT_LEASE = 100_000_000_000L;

  /** Beside names and user data, which are as long as their owners want. */
  private static final int ROOM = 2048;

  private DiscoveryCodec() {}

  static ByteBuffer encode(ParticipantInfo info) {
    ByteBuffer out = begin(ROOM + info.name().length() * 3 + info.userData().length);
    ParameterWriter parameters = new ParameterWriter(out);
    versions(parameters, out);
    parameters.guid(ParameterId.PARTICIPANT_GUID, new Guid(info.prefix(), EntityId.PARTICIPANT));
    parameters.integer(ParameterId.DOMAIN_ID, info.domain());
    for (InetSocketAddress each : info.discovery())
      locator(parameters, out, ParameterId.METATRAFFIC_UNICAST_LOCATOR, each);
    for (InetSocketAddress each : info.user())
      locator(parameters, out, ParameterId.DEFAULT_UNICAST_LOCATOR, each);
    parameters.duration(ParameterId.PARTICIPANT_LEASE, info.lease());
    parameters.integer(ParameterId.BUILTIN_ENDPOINTS, info.builtin());
    if (!info.name().isEmpty()) parameters.string(ParameterId.ENTITY_NAME, info.name());
    if (info.userData().length > 0) parameters.octets(ParameterId.USER_DATA, info.userData());
    parameters.finish();
    return out.flip();
  }

  static ByteBuffer encode(EndpointInfo info) {
    ByteBuffer out =
        begin(ROOM + (info.topic().length() + info.type().length()) * 3 + info.userData().length);
    ParameterWriter parameters = new ParameterWriter(out);
    EndpointQos qos = info.qos();
    versions(parameters, out);
    parameters.guid(ParameterId.ENDPOINT_GUID, info.guid());
    parameters.guid(
        ParameterId.PARTICIPANT_GUID, new Guid(info.guid().prefix(), EntityId.PARTICIPANT));
    parameters.guid(ParameterId.KEY_HASH, info.guid());
    parameters.string(ParameterId.TOPIC_NAME, info.topic());
    parameters.string(ParameterId.TYPE_NAME, info.type());
    for (InetSocketAddress each : info.locators())
      locator(parameters, out, ParameterId.UNICAST_LOCATOR, each);
    parameters.begin(ParameterId.RELIABILITY);
    out.putInt(qos.reliable() ? RELIABLE : 1);
    Wire.putDuration(out, 100_000_000);
    parameters.end();
    parameters.integer(ParameterId.DURABILITY, qos.transientLocal() ? 1 : 0);
    parameters.duration(ParameterId.DEADLINE, qos.deadline());
    parameters.duration(ParameterId.LIFESPAN, qos.lifespan());
    parameters.begin(ParameterId.LIVELINESS);
    out.putInt(qos.liveliness().ordinal());
    Wire.putDuration(out, qos.lease());
    parameters.end();
    parameters.begin(ParameterId.HISTORY);
    out.putInt(qos.depth() == EndpointQos.KEEP_ALL ? 1 : 0).putInt(Math.max(1, qos.depth()));
    parameters.end();
    if (info.userData().length > 0) parameters.octets(ParameterId.USER_DATA, info.userData());
    parameters.finish();
    return out.flip();
  }

  /** The key of a participant, writer or reader that is no more. */
  static ByteBuffer encodeKey(Guid guid) {
    ByteBuffer out = begin(ROOM);
    ParameterWriter parameters = new ParameterWriter(out);
    boolean participant = guid.entity() == EntityId.PARTICIPANT;
    parameters.guid(participant ? ParameterId.PARTICIPANT_GUID : ParameterId.ENDPOINT_GUID, guid);
    parameters.finish();
    return out.flip();
  }

  private static ByteBuffer begin(int room) {
    return ByteBuffer.allocate(room)
        .putShort((short) PARAMETERS_LITTLE)
        .putShort((short) 0)
        .order(ByteOrder.LITTLE_ENDIAN);
  }

  private static void versions(ParameterWriter parameters, ByteBuffer out) {
    parameters.begin(ParameterId.PROTOCOL_VERSION);
    out.put((byte) 2).put((byte) 3);
    parameters.end();
    parameters.begin(ParameterId.VENDOR_ID);
    out.put((byte) (MessageBuilder.VENDOR >> 8)).put((byte) MessageBuilder.VENDOR);
    parameters.end();
  }

  private static void locator(
      ParameterWriter parameters, ByteBuffer out, int id, InetSocketAddress address) {
    parameters.begin(id);
    out.putInt(UDP_V4).putInt(address.getPort());
    out.putLong(0).putInt(0).put(address.getAddress().getAddress());
    parameters.end();
  }

  static ParticipantInfo decodeParticipant(ByteBuffer payload) throws MalformedException {
    Guid guid = Guid.UNKNOWN;
    int domain = -1;
    String name = "";
    byte[] userData = new byte[0];
    List<InetSocketAddress> discovery = new ArrayList<>();
    List<InetSocketAddress> user = new ArrayList<>();
    long lease = DEFAULT_LEASE;
    int builtin = 0;
    try {
      ParameterReader parameters = new ParameterReader(list(payload));
      while (parameters.next()) {
        ByteBuffer value = parameters.value();
        switch (parameters.id()) {
          case ParameterId.PARTICIPANT_GUID -> guid = Guid.read(value);
          case ParameterId.DOMAIN_ID -> domain = value.getInt();
          case ParameterId.ENTITY_NAME -> name = Wire.string(value);
          case ParameterId.USER_DATA -> userData = octets(value);
          case ParameterId.METATRAFFIC_UNICAST_LOCATOR -> addLocator(discovery, value);
          case ParameterId.DEFAULT_UNICAST_LOCATOR -> addLocator(user, value);
          case ParameterId.PARTICIPANT_LEASE -> lease = Wire.duration(value);
          case ParameterId.BUILTIN_ENDPOINTS -> builtin = value.getInt();
          default -> {}
        }
      }
    } catch (BufferUnderflowException e) {
      throw new MalformedException("truncated description of a participant");
    }
    if (guid.entity() != EntityId.PARTICIPANT)
      throw new MalformedException("description of nobody");
    return new ParticipantInfo(
        guid.prefix(),
        domain,
        name,
        userData,
        List.copyOf(discovery),
        List.copyOf(user),
        lease,
        builtin);
  }

  static EndpointInfo decodeEndpoint(ByteBuffer payload, boolean isWriter)
      throws MalformedException {
    Guid guid = Guid.UNKNOWN;
    String topic = "";
    String type = "";
    byte[] userData = new byte[0];
    boolean exclusive = false;
    List<InetSocketAddress> locators = new ArrayList<>();
    List<String> partitions = new ArrayList<>();
    // Who says nothing: a writer is reliable, a reader is not.
    boolean reliable = isWriter;
    boolean transientLocal = false;
    int depth = 1;
    long deadline = EndpointQos.INFINITE;
    long lifespan = EndpointQos.INFINITE;
    Liveliness liveliness = Liveliness.AUTOMATIC;
    long lease = EndpointQos.INFINITE;
    try {
      ParameterReader parameters = new ParameterReader(list(payload));
      while (parameters.next()) {
        ByteBuffer value = parameters.value();
        switch (parameters.id()) {
          case ParameterId.ENDPOINT_GUID -> guid = Guid.read(value);
          case ParameterId.TOPIC_NAME -> topic = Wire.string(value);
          case ParameterId.TYPE_NAME -> type = Wire.string(value);
          case ParameterId.USER_DATA -> userData = octets(value);
          case ParameterId.UNICAST_LOCATOR -> addLocator(locators, value);
          case ParameterId.RELIABILITY -> reliable = value.getInt() >= RELIABLE;
          case ParameterId.DURABILITY -> transientLocal = value.getInt() >= 1;
          case ParameterId.DEADLINE -> deadline = positive(Wire.duration(value));
          case ParameterId.LIFESPAN -> lifespan = positive(Wire.duration(value));
          case ParameterId.LIVELINESS -> {
            liveliness = Liveliness.values()[Math.clamp(value.getInt(), 0, 2)];
            lease = positive(Wire.duration(value));
          }
          case ParameterId.HISTORY ->
              depth = value.getInt() == 0 ? Math.max(1, value.getInt()) : EndpointQos.KEEP_ALL;
          case ParameterId.OWNERSHIP -> exclusive = value.getInt() != 0;
          case ParameterId.PARTITION -> readPartitions(value, partitions);
          default -> {}
        }
      }
    } catch (BufferUnderflowException e) {
      throw new MalformedException("truncated description of an endpoint");
    }
    boolean known =
        isWriter ? EntityId.isUserWriter(guid.entity()) : EntityId.isUserReader(guid.entity());
    if (!known || topic.isEmpty()) throw new MalformedException("description of no endpoint");
    EndpointQos qos =
        new EndpointQos(reliable, transientLocal, depth, deadline, lifespan, liveliness, lease);
    return new EndpointInfo(
        guid,
        isWriter,
        topic,
        type,
        qos,
        userData,
        List.copyOf(locators),
        exclusive,
        List.copyOf(partitions));
  }

  /** Of whom a description without data speaks; {@link Guid#UNKNOWN} if of nobody. */
  static Guid decodeKey(ByteBuffer payload) throws MalformedException {
    try {
      ParameterReader parameters = new ParameterReader(list(payload));
      while (parameters.next())
        if (parameters.id() == ParameterId.ENDPOINT_GUID
            || parameters.id() == ParameterId.PARTICIPANT_GUID)
          return Guid.read(parameters.value());
      return Guid.UNKNOWN;
    } catch (BufferUnderflowException e) {
      throw new MalformedException("truncated key");
    }
  }

  private static ByteBuffer list(ByteBuffer payload) throws MalformedException {
    ByteBuffer in = payload.duplicate().order(ByteOrder.BIG_ENDIAN);
    int representation = in.getShort();
    in.getShort();
    return switch (representation) {
      case PARAMETERS_BIG -> in;
      case PARAMETERS_LITTLE -> in.order(ByteOrder.LITTLE_ENDIAN);
      default -> throw new MalformedException("description in representation " + representation);
    };
  }

  private static long positive(long nanos) {
    return Math.max(1, nanos);
  }

  private static byte[] octets(ByteBuffer in) throws MalformedException {
    int length = in.getInt();
    if (length < 0 || length > in.remaining())
      throw new MalformedException("user data longer than their message");
    byte[] bytes = new byte[length];
    in.get(bytes);
    return bytes;
  }

  private static void readPartitions(ByteBuffer in, List<String> partitions)
      throws MalformedException {
    int count = in.getInt();
    if (count < 0 || count > PARTITIONS) throw new MalformedException("too many partitions");
    for (int i = 0; i < count; i++) {
      partitions.add(Wire.string(in));
      in.position(Math.min(in.limit(), (in.position() + 3) / 4 * 4));
    }
  }

  /** Adds an address of UDP over IPv4; others, such as those of shared memory, are not for us. */
  private static void addLocator(List<InetSocketAddress> addresses, ByteBuffer in)
      throws MalformedException {
    int kind = in.getInt();
    int port = in.getInt();
    in.getLong();
    in.getInt();
    byte[] address = new byte[4];
    in.get(address);
    if (kind != UDP_V4 || port <= 0 || port > 0xffff || addresses.size() >= LOCATORS) return;
    try {
      addresses.add(new InetSocketAddress(InetAddress.getByAddress(address), port));
    } catch (UnknownHostException e) {
      throw new MalformedException("address of " + address.length + " bytes");
    }
  }
}
