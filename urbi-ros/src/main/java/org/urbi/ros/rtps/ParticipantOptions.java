package org.urbi.ros.rtps;

import java.net.InetAddress;
import java.time.Duration;
import java.util.function.Consumer;

/**
 * How a participant behaves.
 *
 * @param domain participants of different domains know nothing of each other: 0 to 232
 * @param address the address that it receives at; a loopback address: only this machine's
 *     participants are heard
 * @param name what it is called where participants are listed
 * @param userData for other participants to see
 * @param lease others forget it when they hear nothing for so long
 * @param linger how long what is closed goes on serving readers that do not have everything yet
 * @param fragmentSize larger payloads are sent in fragments of so many bytes
 * @param largestSample longer ones, in bytes, are neither sent nor received
 * @param memory how many bytes each history, each reader's queue, and all half received samples
 *     together may take
 * @param participants so many others are known at once; for 0, none of them knows this one, either
 * @param endpoints each of them has at most so many writers and readers
 */
public record ParticipantOptions(
    int domain,
    InetAddress address,
    String name,
    byte[] userData,
    Duration lease,
    Duration linger,
    int fragmentSize,
    int largestSample,
    long memory,
    int participants,
    int endpoints) {

  private static final int GREATEST_DOMAIN = 232;
  private static final int MEGA = 1 << 20;

  /** Checks the ranges. */
  public ParticipantOptions {
    if (domain < 0 || domain > GREATEST_DOMAIN)
      throw new IllegalArgumentException(
          "domain " + domain + " is not between 0 and " + GREATEST_DOMAIN);
    if (fragmentSize < 1024 || fragmentSize > MessageBuilder.LARGEST - MessageBuilder.OVERHEAD)
      throw new IllegalArgumentException(
          "fragments of " + fragmentSize + " bytes: take 1024 to 65251");
  }

  /** On loopback, with fragments of 60,000 bytes, samples of at most 64 MB. */
  public static ParticipantOptions loopback(int domain) {
    return new ParticipantOptions(
        domain,
        InetAddress.ofLiteral("127.0.0.1"),
        "",
        new byte[0],
        Duration.ofSeconds(10),
        Duration.ofSeconds(1),
        60_000,
        64 * MEGA,
        128L * MEGA,
        256,
        4096);
  }

  /** A copy with that name. */
  public ParticipantOptions withName(String text) {
    return with(draft -> draft.name = text);
  }

  /** A copy with that data for others to see. */
  public ParticipantOptions withUserData(byte[] bytes) {
    return with(draft -> draft.userData = bytes);
  }

  /** A copy with that address. */
  public ParticipantOptions withAddress(InetAddress where) {
    return with(draft -> draft.address = where);
  }

  /** A copy with that lease: others forget the participant when it is silent for so long. */
  public ParticipantOptions withLease(Duration time) {
    return with(draft -> draft.lease = time);
  }

  /** A copy whose end may take so long. */
  public ParticipantOptions withLinger(Duration time) {
    return with(draft -> draft.linger = time);
  }

  /** A copy with fragments of so many bytes. */
  public ParticipantOptions withFragmentSize(int bytes) {
    return with(draft -> draft.fragmentSize = bytes);
  }

  /**
   * A copy with limits of memory: at most so many bytes of each history are kept, and larger
   * samples are not received.
   */
  public ParticipantOptions withMemory(int sample, long bytes) {
    return with(draft -> {
      draft.largestSample = sample;
      draft.memory = bytes;
    });
  }

  /** A copy with limits: so many other participants, with so many writers and readers each. */
  public ParticipantOptions withLimits(int others, int each) {
    return with(draft -> {
      draft.participants = others;
      draft.endpoints = each;
    });
  }

  private ParticipantOptions with(Consumer<Draft> change) {
    Draft draft = new Draft(this);
    change.accept(draft);
    return draft.options();
  }

  /** Options that are being changed. */
  private static final class Draft {
    private final int domain;
    private InetAddress address;
    private String name;
    private byte[] userData;
    private Duration lease;
    private Duration linger;
    private int fragmentSize;
    private int largestSample;
    private long memory;
    private int participants;
    private int endpoints;

    Draft(ParticipantOptions from) {
      domain = from.domain;
      address = from.address;
      name = from.name;
      userData = from.userData;
      lease = from.lease;
      linger = from.linger;
      fragmentSize = from.fragmentSize;
      largestSample = from.largestSample;
      memory = from.memory;
      participants = from.participants;
      endpoints = from.endpoints;
    }

    ParticipantOptions options() {
      return new ParticipantOptions(
          domain,
          address,
          name,
          userData,
          lease,
          linger,
          fragmentSize,
          largestSample,
          memory,
          participants,
          endpoints);
    }
  }
}
