package org.urbi.ros.rtps;

import java.nio.ByteBuffer;
import org.urbi.ros.time.SteadyClock;

/**
 * A sample in the history of a writer.
 *
 * @param sequence its number, from 1
 * @param time nanoseconds since 1970
 * @param written {@link SteadyClock#nanoseconds} when it was written
 * @param payload with its encapsulation header; nobody moves its position
 */
record Change(long sequence, long time, long written, ByteBuffer payload, InlineQos qos) {
  int size() {
    return payload.remaining();
  }

  /** How many fragments of that size it has. */
  int fragments(int fragmentSize) {
    return (size() + fragmentSize - 1) / fragmentSize;
  }
}
