package org.urbi.ros.rtps;

/** Identifiers of the parameters that this participant reads or writes. */
final class ParameterId {
  static final int PAD = 0x0000;
  static final int SENTINEL = 0x0001;
  static final int PARTICIPANT_LEASE = 0x0002;
  static final int TOPIC_NAME = 0x0005;
  static final int TYPE_NAME = 0x0007;
  static final int DOMAIN_ID = 0x000f;
  static final int PROTOCOL_VERSION = 0x0015;
  static final int VENDOR_ID = 0x0016;
  static final int RELIABILITY = 0x001a;
  static final int LIVELINESS = 0x001b;
  static final int DURABILITY = 0x001d;
  static final int OWNERSHIP = 0x001f;
  static final int DEADLINE = 0x0023;
  static final int PARTITION = 0x0029;
  static final int LIFESPAN = 0x002b;
  static final int USER_DATA = 0x002c;
  static final int UNICAST_LOCATOR = 0x002f;
  static final int DEFAULT_UNICAST_LOCATOR = 0x0031;
  static final int METATRAFFIC_UNICAST_LOCATOR = 0x0032;
  static final int METATRAFFIC_MULTICAST_LOCATOR = 0x0033;
  static final int HISTORY = 0x0040;
  static final int PARTICIPANT_GUID = 0x0050;
  static final int BUILTIN_ENDPOINTS = 0x0058;
  static final int ENDPOINT_GUID = 0x005a;
  static final int ENTITY_NAME = 0x0062;
  static final int KEY_HASH = 0x0070;
  static final int STATUS_INFO = 0x0071;
  static final int RELATED_SAMPLE_IDENTITY = 0x0083;
  static final int RELATED_SAMPLE_IDENTITY_OF_FAST_DDS = 0x800f;

  /**
   * "Whoever does not know this one must not go on." The bit above it is the vendors': it belongs
   * to the identifier.
   */
  static final int MUST_UNDERSTAND = 0x4000;

  private ParameterId() {}
}
