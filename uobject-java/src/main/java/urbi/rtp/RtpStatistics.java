package urbi.rtp;

import java.util.concurrent.atomic.LongAdder;

/** Counts frames and datagrams by what became of them. */
public final class RtpStatistics {
  final LongAdder sent = new LongAdder();
  final LongAdder replaced = new LongAdder();
  final LongAdder received = new LongAdder();
  final LongAdder incomplete = new LongAdder();
  final LongAdder late = new LongAdder();
  final LongAdder duplicates = new LongAdder();
  final LongAdder refused = new LongAdder();

  /** Frames that were sent. */
  public long sent() {
    return sent.sum();
  }

  /** Frames that were not sent, since there was a newer one before there was room. */
  public long replaced() {
    return replaced.sum();
  }

  /** Frames that have come whole, and in their order. */
  public long received() {
    return received.sum();
  }

  /** Frames that have come in part. */
  public long incomplete() {
    return incomplete.sum();
  }

  /** Datagrams that came after a newer frame of their variable. */
  public long late() {
    return late.sum();
  }

  /** Datagrams that had come before. */
  public long duplicates() {
    return duplicates.sum();
  }

  /** Datagrams of strangers, and what is none at all. */
  public long refused() {
    return refused.sum();
  }

  @Override
  public String toString() {
    return "sent "
        + sent
        + ", replaced "
        + replaced
        + ", received "
        + received
        + ", incomplete "
        + incomplete
        + ", late "
        + late
        + ", duplicates "
        + duplicates
        + ", refused "
        + refused;
  }
}
