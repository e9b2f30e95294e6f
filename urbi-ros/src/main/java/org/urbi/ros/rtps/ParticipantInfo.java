package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.util.List;

/**
 * What a participant says about itself.
 *
 * @param domain its domain, -1 if it does not say
 * @param discovery where it listens to what is about discovery
 * @param user where its readers and writers listen, unless they say otherwise
 * @param lease nanoseconds after which it is gone, if nothing is heard of it
 * @param builtin which of the built-in writers and readers it has, a bit each
 */
public record ParticipantInfo(
    GuidPrefix prefix,
    int domain,
    String name,
    byte[] userData,
    List<InetSocketAddress> discovery,
    List<InetSocketAddress> user,
    long lease,
    int builtin) {

  static final int PARTICIPANT_WRITER = 1;
  static final int PARTICIPANT_READER = 1 << 1;
  static final int PUBLICATIONS_WRITER = 1 << 2;
  static final int PUBLICATIONS_READER = 1 << 3;
  static final int SUBSCRIPTIONS_WRITER = 1 << 4;
  static final int SUBSCRIPTIONS_READER = 1 << 5;
  static final int LIVELINESS_WRITER = 1 << 10;
  static final int LIVELINESS_READER = 1 << 11;
  static final int ALL =
      PARTICIPANT_WRITER
          | PARTICIPANT_READER
          | PUBLICATIONS_WRITER
          | PUBLICATIONS_READER
          | SUBSCRIPTIONS_WRITER
          | SUBSCRIPTIONS_READER
          | LIVELINESS_WRITER
          | LIVELINESS_READER;

  boolean has(int endpoint) {
    return (builtin & endpoint) != 0;
  }
}
