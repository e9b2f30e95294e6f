package urbi.rtp;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Splits frames into datagrams, and sends no more than the other side has room for according to its
 * reports. If a variable changes faster than that, only its newest value is sent.
 *
 * <p>All variables without binaries share a stream; each variable that ever had a binary has its
 * own.
 */
final class RtpSender {
  /** How long a report may take, in milliseconds, until what it should tell of is thought lost. */
  private static final long TIMEOUT_MILLISECONDS = 50;

  /** After so many reports that did not come nothing gets through any more. */
  private static final int MAX_SILENT = 20;

  /** Sends the datagrams. */
  interface DatagramOutput {
    void send(byte[] datagram);

    /** Has something done after a while. */
    void after(long milliseconds, Runnable task);

    long microseconds();

    /** Nothing gets through any more; told once. */
    void broken();
  }

  /** All frames of a variable before this sequence number of a stream are out of date. */
  record Superseded(int ssrc, int sequence) {}

  private static final class Stream {
    private final int ssrc;
    private int next;

    /** The sizes of the last datagrams, of which no report has told yet. */
    private final ArrayDeque<Integer> unreported = new ArrayDeque<>();

    Stream(int ssrc, int first) {
      this.ssrc = ssrc;
      this.next = first;
    }
  }

  private static final class Outgoing {
    private final Stream stream;
    private final int variable;
    private final byte[] frame;
    private final int timestamp;
    private int index;

    Outgoing(Stream stream, int variable, byte[] frame, int timestamp) {
      this.stream = stream;
      this.variable = variable;
      this.frame = frame;
      this.timestamp = timestamp;
    }
  }

  private final RtpParameters own;
  private final RtpParameters other;
  private final RtpStatistics counts;
  private final DatagramOutput out;
  private final int part;
  private final int window;
  private final Map<Integer, Stream> streams = new HashMap<>();

  /** In which stream a variable was sent last, since it was sent otherwise. */
  private final Map<Integer, Stream> used = new HashMap<>();

  private final Map<Integer, Outgoing> waiting = new LinkedHashMap<>();
  private @Nullable Outgoing current;
  private int inFlight;
  private boolean watching;
  private boolean reported;
  private int silent;
  private boolean broken;

  RtpSender(RtpParameters own, RtpParameters other, RtpStatistics counts, DatagramOutput out) {
    this.own = own;
    this.other = other;
    this.counts = counts;
    this.out = out;
    this.part = Math.min(own.datagram(), other.datagram()) - RtpPacket.HEADER;
    this.window = other.window();
  }

  /** Takes a frame, which {@link #sendPending} will send; false if it has to go another way. */
  synchronized boolean offer(int variable, boolean binary, byte[] frame) {
    if (broken || frame.length > (long) part * RtpPacket.MAX_PARTS) {
      return false;
    }
    int timestamp = (int) (out.microseconds() * 9 / 100);
    Stream stream = stream(variable, binary);
    used.put(variable, stream);
    if (waiting.put(variable, new Outgoing(stream, variable, frame, timestamp)) != null) {
      counts.replaced.increment();
    }
    return true;
  }

  private Stream stream(int variable, boolean binary) {
    int single = own.ssrc() + variable;
    int ssrc = binary || streams.containsKey(single) ? single : own.ssrc();
    // Numbers start anywhere, so that they cannot be guessed.
    return streams.computeIfAbsent(
        ssrc, key -> new Stream(key, (int) (own.token() ^ other.token()) + key & 0xffff));
  }

  /** The variable goes another way from now on; null if it has not gone this one. */
  synchronized @Nullable Superseded superseded(int variable) {
    Stream stream = used.remove(variable);
    if (stream == null) {
      return null;
    }
    forget(variable);
    return new Superseded(stream.ssrc, stream.next & 0xffff);
  }

  /** The variable is not used any more. */
  synchronized void close(int variable) {
    used.remove(variable);
    forget(variable);
    Stream single = streams.remove(own.ssrc() + variable);
    if (single != null) {
      single.unreported.forEach(size -> inFlight -= size);
    }
  }

  private void forget(int variable) {
    waiting.remove(variable);
    if (current != null && current.variable == variable) {
      current = null;
    }
  }

  /** Sends as much as there is room for. */
  synchronized void sendPending() {
    while (!broken && (inFlight == 0 || inFlight + part <= window)) {
      Outgoing going = current;
      if (going == null) {
        Iterator<Outgoing> first = waiting.values().iterator();
        if (!first.hasNext()) {
          break;
        }
        going = first.next();
        current = going;
        first.remove();
      }
      sendPart(going);
    }
    if (!broken && !watching && inFlight > 0) {
      watching = true;
      reported = false;
      out.after(TIMEOUT_MILLISECONDS, this::watch);
    }
  }

  private void sendPart(Outgoing going) {
    Stream stream = going.stream;
    int from = going.index * part;
    int to = Math.min(from + part, going.frame.length);
    int count = Math.max(1, (going.frame.length + part - 1) / part);
    byte[] datagram =
        new RtpPacket(
                stream.next++ & 0xffff,
                going.timestamp,
                stream.ssrc,
                other.token(),
                going.variable,
                going.index,
                count,
                Arrays.copyOfRange(going.frame, from, to))
            .toBytes();
    stream.unreported.add(datagram.length);
    inFlight += datagram.length;
    if (++going.index == count) {
      current = null;
      counts.sent.increment();
    }
    out.send(datagram);
  }

  /** Has a report come since? */
  private void watch() {
    boolean over;
    synchronized (this) {
      watching = false;
      if (!reported && inFlight > 0) {
        silent++;
        inFlight = 0;
        streams.values().forEach(stream -> stream.unreported.clear());
      }
      broken |= silent >= MAX_SILENT;
      over = broken;
    }
    if (over) {
      out.broken();
    } else {
      sendPending();
    }
  }

  /** The other side has reported how far it has read. */
  synchronized void reported(Map<Integer, Integer> highest) {
    reported = true;
    silent = 0;
    highest.forEach((ssrc, sequence) -> {
      Stream stream = streams.get(ssrc);
      if (stream != null) {
        int behind = (short) (stream.next - 1 - sequence);
        while (behind >= 0 && stream.unreported.size() > behind) {
          inFlight -= stream.unreported.poll();
        }
      }
    });
    sendPending();
  }
}
