package urbi.rtp;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * Assembles frames from datagrams, which may be lost, duplicated or reordered. A variable never
 * gets an older frame after a newer one; incomplete older frames are dropped.
 */
final class RtpReceiver {
  /** So many frames of a variable may be incomplete at a time: that much disorder is healed. */
  private static final int MAX_INCOMPLETE = 4;

  /** Nor more of all variables, or more bytes of them. */
  private static final int MAX_FRAMES = 256;

  private static final long MAX_BYTES = 64L << 20;

  /** Of so many streams and variables the order is remembered. */
  private static final int MAX_REMEMBERED = 4096;

  private static final class Assembly {
    private final Variable variable;
    private final long first;
    private final byte[][] parts;
    private int missing;
    private int size;

    Assembly(Variable variable, long first, int count) {
      this.variable = variable;
      this.first = first;
      this.parts = new byte[count][];
      this.missing = count;
    }

    byte[] whole() {
      byte[] whole = new byte[size];
      int at = 0;
      for (byte[] part : parts) {
        System.arraycopy(part, 0, whole, at, part.length);
        at += part.length;
      }
      return whole;
    }
  }

  private static final class Variable {
    /** The number after that of the newest frame. */
    private long superseded = Long.MIN_VALUE;

    private final TreeMap<Long, Assembly> incomplete = new TreeMap<>();
  }

  private static final class Stream {
    private long highest;
    private final Map<Integer, Variable> variables = new RecentlyUsed<>();

    Stream(int sequence) {
      // Whatever comes before the first one has a number above 0, too.
      highest = (1L << 16) + sequence;
    }

    /** The number without the modulus (RFC 3550, section 3). */
    long extended(int sequence) {
      return highest + (short) (sequence - (int) highest);
    }
  }

  /** A map that drops the least recently used entry. */
  private static final class RecentlyUsed<V> extends LinkedHashMap<Integer, V> {
    private static final long serialVersionUID = 1;

    RecentlyUsed() {
      super(16, 0.75f, true);
    }

    @Override
    protected boolean removeEldestEntry(Map.Entry<Integer, V> eldest) {
      return size() > MAX_REMEMBERED;
    }
  }

  private final RtpParameters own;
  private final RtpParameters other;
  private final RtpStatistics counts;
  private final int reportAfter;
  private final Map<Integer, Stream> streams = new RecentlyUsed<>();
  private final Set<Assembly> assemblies = new LinkedHashSet<>();
  private final Map<Integer, Integer> unreported = new LinkedHashMap<>();
  private long bytes;
  private int unreportedBytes;

  RtpReceiver(RtpParameters own, RtpParameters other, RtpStatistics counts) {
    this.own = own;
    this.other = other;
    this.counts = counts;
    // Four reports in what the other side sends without one.
    this.reportAfter = own.window() / 4;
  }

  /**
   * Takes a datagram, which shows the right token; returns the frame that it completes, or null.
   */
  synchronized byte @Nullable [] take(RtpPacket packet) {
    int ssrc = packet.ssrc();
    if (ssrc != other.ssrc() && ssrc != other.ssrc() + packet.variable()) {
      counts.refused.increment();
      return null;
    }
    Stream stream = streams.computeIfAbsent(ssrc, key -> new Stream(packet.sequence()));
    long number = stream.extended(packet.sequence());
    stream.highest = Math.max(stream.highest, number);
    unreported.put(ssrc, (int) stream.highest);
    unreportedBytes += RtpPacket.HEADER + packet.data().length;
    Variable variable = stream.variables.computeIfAbsent(packet.variable(), key -> new Variable());
    long first = number - packet.index();
    if (first < variable.superseded) {
      counts.late.increment();
      return null;
    }
    Assembly assembly =
        variable.incomplete.computeIfAbsent(
            first, key -> new Assembly(variable, key, packet.count()));
    assemblies.add(assembly);
    if (assembly.parts.length != packet.count()) {
      counts.refused.increment();
      return null;
    }
    if (assembly.parts[packet.index()] != null) {
      counts.duplicates.increment();
      return null;
    }
    return add(assembly, packet);
  }

  private byte @Nullable [] add(Assembly assembly, RtpPacket packet) {
    Variable variable = assembly.variable;
    assembly.parts[packet.index()] = packet.data();
    assembly.size += packet.data().length;
    bytes += packet.data().length;
    if (--assembly.missing == 0) {
      remove(assembly);
      forget(variable, assembly.first + packet.count());
      counts.received.increment();
      return assembly.whole();
    }
    if (variable.incomplete.size() > MAX_INCOMPLETE) {
      giveUp(variable.incomplete.firstEntry().getValue());
    }
    while (assemblies.size() > MAX_FRAMES || bytes > MAX_BYTES) {
      giveUp(assemblies.iterator().next());
    }
    return null;
  }

  private void remove(Assembly assembly) {
    assembly.variable.incomplete.remove(assembly.first);
    assemblies.remove(assembly);
    bytes -= assembly.size;
  }

  private void giveUp(Assembly assembly) {
    Variable variable = assembly.variable;
    remove(assembly);
    variable.superseded = Math.max(variable.superseded, assembly.first + 1);
    counts.incomplete.increment();
  }

  /** What begins before a number is out of date. */
  private void forget(Variable variable, long superseded) {
    variable.superseded = Math.max(variable.superseded, superseded);
    while (!variable.incomplete.isEmpty() && variable.incomplete.firstKey() < superseded) {
      giveUp(variable.incomplete.firstEntry().getValue());
    }
  }

  /** The other side sends the variable otherwise: what it has sent before is out of date. */
  synchronized void superseded(int variable, RtpSender.Superseded superseded) {
    Stream stream =
        streams.computeIfAbsent(superseded.ssrc(), key -> new Stream(superseded.sequence()));
    forget(
        stream.variables.computeIfAbsent(variable, key -> new Variable()),
        stream.extended(superseded.sequence()));
  }

  /**
   * What to report.
   *
   * @param now whether little is worth a report, too
   * @return null if it is not time yet, or there is nothing
   */
  synchronized @Nullable RtcpPacket report(boolean now) {
    boolean much = unreportedBytes >= reportAfter || unreported.size() >= RtcpPacket.MAX_BLOCKS;
    if (unreported.isEmpty() || !much && !now) {
      return null;
    }
    var report =
        new RtcpPacket(RtcpPacket.Kind.REPORT, own.ssrc(), other.token(), Map.copyOf(unreported));
    unreported.clear();
    unreportedBytes = 0;
    return report;
  }
}
