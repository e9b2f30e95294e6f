package org.urbi.ros.rtps;

/**
 * Whose submessages follow in a datagram, and whom they are for.
 *
 * @param destination {@link GuidPrefix#UNKNOWN}: for everybody
 * @param time nanoseconds since 1970, 0 if unknown
 */
record MessageSource(GuidPrefix sender, GuidPrefix destination, long time) {
  MessageSource from(GuidPrefix other) {
    return new MessageSource(other, destination, time);
  }

  MessageSource to(GuidPrefix other) {
    return new MessageSource(sender, other, time);
  }

  MessageSource at(long nanos) {
    return new MessageSource(sender, destination, nanos);
  }
}
