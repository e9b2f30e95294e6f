package org.urbi.ros.rtps;

/**
 * What a writer offers or a reader requests. Durations are nanoseconds.
 *
 * @param reliable whether samples that are lost are sent again; otherwise at best effort
 * @param transientLocal whether readers that come later get what the writer keeps
 * @param depth how many samples are kept; {@link #KEEP_ALL}: as many as memory allows, then the
 *     writer is told to wait
 * @param deadline a sample comes at least this often
 * @param lifespan older samples are of no use
 * @param liveliness how a writer shows that it is alive
 * @param lease within which time it does so
 */
public record EndpointQos(
    boolean reliable,
    boolean transientLocal,
    int depth,
    long deadline,
    long lifespan,
    Liveliness liveliness,
    long lease) {

  /** A duration without end. */
  public static final long INFINITE = Long.MAX_VALUE;

  /** The depth of a history that drops nothing. */
  public static final int KEEP_ALL = 0;

  /** How a writer shows that it is alive, the weakest first. */
  public enum Liveliness {
    /** The participant says so by itself. */
    AUTOMATIC,
    /** Each sample and assertion of one such writer says so for all of the participant. */
    MANUAL_BY_PARTICIPANT,
    /** The samples and assertions of a writer say so, for this writer alone. */
    MANUAL_BY_TOPIC
  }

  /** Reliable, volatile, with that depth: what ROS 2 calls the default with 10. */
  public static EndpointQos reliable(int depth) {
    return new EndpointQos(true, false, depth, INFINITE, INFINITE, Liveliness.AUTOMATIC, INFINITE);
  }

  /** Best effort, volatile, with that depth. */
  public static EndpointQos bestEffort(int depth) {
    return new EndpointQos(false, false, depth, INFINITE, INFINITE, Liveliness.AUTOMATIC, INFINITE);
  }

  /** Checks that nothing is negative. */
  public EndpointQos {
    if (depth < 0) throw new IllegalArgumentException("depth " + depth + " is negative");
    if (deadline <= 0 || lifespan <= 0 || lease <= 0)
      throw new IllegalArgumentException("deadline, lifespan and lease have to be positive");
  }

  /** A copy of which readers that come later get what is kept. */
  public EndpointQos asTransientLocal() {
    return new EndpointQos(reliable, true, depth, deadline, lifespan, liveliness, lease);
  }

  /** A copy with that deadline, in nanoseconds. */
  public EndpointQos withDeadline(long nanos) {
    return new EndpointQos(reliable, transientLocal, depth, nanos, lifespan, liveliness, lease);
  }

  /** A copy whose samples are of no use after so many nanoseconds. */
  public EndpointQos withLifespan(long nanos) {
    return new EndpointQos(reliable, transientLocal, depth, deadline, nanos, liveliness, lease);
  }

  /** A copy with that liveliness, shown at least every {@code nanos}. */
  public EndpointQos withLiveliness(Liveliness kind, long nanos) {
    return new EndpointQos(reliable, transientLocal, depth, deadline, lifespan, kind, nanos);
  }

  /**
   * Why a writer that offers this cannot serve a reader that requests {@code other}: a policy's
   * name, or "" if it can.
   */
  public String hinders(EndpointQos other) {
    if (other.reliable && !reliable) return "reliability";
    if (other.transientLocal && !transientLocal) return "durability";
    if (other.deadline < deadline) return "deadline";
    if (other.liveliness.compareTo(liveliness) > 0 || other.lease < lease) return "liveliness";
    return "";
  }
}
