package org.urbi.ros.rtps;

/**
 * Entity identifiers that the protocol fixes, and the kinds that end those of users' writers and
 * readers.
 */
final class EntityId {
  static final int UNKNOWN = 0;
  static final int PARTICIPANT = 0x000001c1;
  static final int PARTICIPANT_WRITER = 0x000100c2;
  static final int PARTICIPANT_READER = 0x000100c7;
  static final int PUBLICATIONS_WRITER = 0x000003c2;
  static final int PUBLICATIONS_READER = 0x000003c7;
  static final int SUBSCRIPTIONS_WRITER = 0x000004c2;
  static final int SUBSCRIPTIONS_READER = 0x000004c7;
  static final int LIVELINESS_WRITER = 0x000200c2;
  static final int LIVELINESS_READER = 0x000200c7;

  private static final int KIND = 0xff;
  private static final int WRITER_WITHOUT_KEY = 0x03;
  private static final int READER_WITHOUT_KEY = 0x04;
  private static final int NUMBERS = 0xffffff;

  private EntityId() {}

  static int writer(int number) {
    return (number & NUMBERS) << 8 | WRITER_WITHOUT_KEY;
  }

  static int reader(int number) {
    return (number & NUMBERS) << 8 | READER_WITHOUT_KEY;
  }

  /** Whether a user's writer may have this identifier. */
  static boolean isUserWriter(int entity) {
    int kind = entity & KIND;
    return kind == WRITER_WITHOUT_KEY || kind == 0x02;
  }

  /** Whether a user's reader may have this identifier. */
  static boolean isUserReader(int entity) {
    int kind = entity & KIND;
    return kind == READER_WITHOUT_KEY || kind == 0x07;
  }
}
