package org.urbi.ros.two;

import static java.util.Objects.requireNonNull;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicInteger;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UValue;

/**
 * The names of goals: {@code unique_identifier_msgs/UUID}. Those of this node begin with what no
 * other one has, and end with a number.
 */
final class GoalIds {
  /** What stands for all goals. */
  static final UUID ALL = new UUID(0, 0);

  private static final int SIZE = 16;
  private static final int PREFIX = 12;

  private final byte[] identity;
  private final AtomicInteger count = new AtomicInteger();

  GoalIds(byte[] identity) {
    this.identity = Arrays.copyOf(identity, PREFIX);
  }

  UUID next() {
    ByteBuffer bytes = ByteBuffer.allocate(SIZE).put(identity).putInt(count.incrementAndGet());
    return read(bytes.flip());
  }

  private static UUID read(ByteBuffer bytes) {
    return new UUID(bytes.getLong(), bytes.getLong());
  }

  /** The one in {@code goal_id} of a message. */
  static UUID of(UDictionary message) {
    UDictionary id = part(message, "goal_id").udictionaryValue();
    return read(ByteBuffer.wrap(part(id, "uuid").ubinaryValue().getData()));
  }

  static UDictionary message(UUID id) {
    byte[] bytes =
        ByteBuffer.allocate(SIZE)
            .putLong(id.getMostSignificantBits())
            .putLong(id.getLeastSignificantBits())
            .array();
    return new UDictionary().with("uuid", new UBinary(bytes));
  }

  /** A field of a message that was decoded, and has all that are in its type. */
  static UValue part(UDictionary message, String name) {
    return requireNonNull(message.get(name), "a decoded message has all its fields");
  }
}
