package org.urbi.kernel.outside;

/**
 * Whether collections of garbage leave too little room: none to speak of, or so little that they
 * come again and again, and the program stands still for much of the time.
 */
final class RoomLeft {
  /** If more than this share of the room is in use after a collection, nearly none is left. */
  static final double FULL = 0.92;

  /** If more than this share is in use, others have all garbage collected again and again. */
  private static final double TIGHT = 1 - 1.0 / 8;

  /** The share of the time that collections may take whatever they leave. */
  private static final double MOST = 0.8;

  /** The share that they may take where they leave little: nobody keeps his periods beyond it. */
  private static final double MOST_IF_TIGHT = 0.2;

  private final CollectingShare share = new CollectingShare(MOST);
  private final CollectingShare shareIfTight = new CollectingShare(MOST_IF_TIGHT);

  /**
   * To be called several times a second.
   *
   * @param now the time in nanoseconds
   * @param used the share of the room that the last collection has left in use
   * @param collecting how long the program has stood still so far, in nanoseconds
   * @param collections how many collections there were so far
   * @param whole how many of them were of all garbage
   */
  boolean isTooLittle(long now, double used, long collecting, long collections, long whole) {
    boolean much = share.isTooMuch(now, collecting, collections);
    if (used <= TIGHT) {
      shareIfTight.forget();
      return much;
    }
    return shareIfTight.isTooMuch(now, collecting, whole) || much || used > FULL;
  }

  /** Memory is no longer scarce. */
  void forget() {
    share.forget();
    shareIfTight.forget();
  }

  /**
   * Somebody has been asked to give back memory. Where little is left, how much of the time
   * collections take is measured anew: those that look whether it has helped are no reason to ask
   * the next one.
   */
  void expectRelief() {
    shareIfTight.forget();
  }
}
