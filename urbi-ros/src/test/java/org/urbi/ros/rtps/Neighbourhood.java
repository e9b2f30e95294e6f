package org.urbi.ros.rtps;

import java.io.IOException;
import java.net.BindException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadLocalRandom;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.Awaited;

/**
 * Participants of one domain, which no other test uses at the time, and what is told about them.
 */
public final class Neighbourhood implements AutoCloseable {
  static final String TYPE = "std_msgs::msg::dds_::String_";
  static final byte[] NO_DATA = {};

  /** Above, the ports would be those that the system gives to anybody. */
  private static final int DOMAINS = 95;

  private final List<Participant> participants = new ArrayList<>();
  private final ServerSocket guard;
  final int domain;

  /** What was told of others, and what went wrong. */
  final BlockingQueue<String> told = new LinkedBlockingQueue<>();

  private final List<String> seen = new ArrayList<>();
  private final Queue<Throwable> troubles = new ConcurrentLinkedQueue<>();

  /** What kinds of trouble a test makes. */
  private final List<Class<? extends Exception>> expected = new CopyOnWriteArrayList<>();

  public Neighbourhood() throws IOException {
    ServerSocket free = null;
    int tried = ThreadLocalRandom.current().nextInt(DOMAINS);
    while (free == null) {
      tried = tried % DOMAINS + 1;
      free = take(tried);
    }
    guard = free;
    domain = tried;
  }

  /**
   * Keeps other tests out of a domain, unless one of them has it, or somebody else is in it: a
   * program that a test has left behind, which would answer in place of the one that is meant.
   */
  private static @Nullable ServerSocket take(int domain) throws IOException {
    int port = 7400 + 250 * domain;
    ServerSocket taken;
    try {
      taken = new ServerSocket(port, 1, InetAddress.getLoopbackAddress());
    } catch (BindException e) {
      return null;
    }
    // All participants share the port of the domain; nobody has it for himself if there are any.
    try (DatagramSocket all = new DatagramSocket(null)) {
      all.setReuseAddress(false);
      all.bind(new InetSocketAddress(port));
      return taken;
    } catch (BindException e) {
      taken.close();
      return null;
    }
  }

  /** Its number. */
  public int domain() {
    return domain;
  }

  ParticipantOptions options() {
    return ParticipantOptions.loopback(domain).withUserData("enclave=/;".getBytes());
  }

  static GuidPrefix prefix() {
    ThreadLocalRandom random = ThreadLocalRandom.current();
    return new GuidPrefix(random.nextInt(), random.nextInt(), random.nextInt());
  }

  Participant open() throws IOException {
    return open(options(), prefix(), new Link(0, 0));
  }

  Participant open(UnaryOperator<DatagramSink> link) throws IOException {
    return open(options(), prefix(), link);
  }

  Participant open(ParticipantOptions options, GuidPrefix prefix, UnaryOperator<DatagramSink> link)
      throws IOException {
    Participant participant = Participant.open(options, new Listener(), prefix, link);
    participants.add(participant);
    return participant;
  }

  /**
   * Trouble of that kind is what the test is about. To be called before it is made: what has been
   * sent may arrive until, and even while, the participants are closed.
   */
  void expect(Class<? extends Exception> trouble) {
    expected.add(trouble);
  }

  /** Waits until this has been told, after what was waited for before or together with it. */
  void awaitTold(String what) throws InterruptedException {
    while (!seen.remove(what)) seen.add(Awaited.next(told, what + " not among " + seen));
  }

  @Override
  public void close() throws IOException {
    participants.forEach(Participant::close);
    guard.close();
    if (!troubles.isEmpty()) throw new AssertionError("something went wrong", troubles.peek());
  }

  private final class Listener implements ParticipantListener {
    @Override
    public void found(ParticipantInfo participant) {
      told.add("found " + participant.prefix());
    }

    @Override
    public void lost(ParticipantInfo participant) {
      told.add("lost " + participant.prefix());
    }

    @Override
    public void found(EndpointInfo endpoint) {
      told.add("found " + endpoint.topic());
    }

    @Override
    public void lost(EndpointInfo endpoint) {
      told.add("lost " + endpoint.topic());
    }

    @Override
    public void trouble(String what, Throwable reason) {
      told.add("trouble " + what);
      if (expected.stream().noneMatch(kind -> kind.isInstance(reason))) troubles.add(reason);
    }
  }

  /** A writer that tells when it is matched. */
  static final class Sending implements WriterListener {
    final CountDownLatch matched = new CountDownLatch(1);
    final CountDownLatch unmatched = new CountDownLatch(1);
    final CountDownLatch room = new CountDownLatch(1);
    final BlockingQueue<String> hindered = new LinkedBlockingQueue<>();

    void awaitMatched() throws InterruptedException {
      Awaited.zero(matched, "no reader");
    }

    @Override
    public void matched(Writer writer, EndpointInfo reader) {
      matched.countDown();
    }

    @Override
    public void unmatched(Writer writer, Guid reader) {
      unmatched.countDown();
    }

    @Override
    public void room(Writer writer) {
      room.countDown();
    }

    @Override
    public void hindered(Writer writer, EndpointInfo reader, String policy) {
      hindered.add(policy);
    }
  }

  /** A reader whose samples are taken at once, or when the test wants to. */
  static final class Receiving implements ReaderListener {
    final BlockingQueue<Sample> samples = new LinkedBlockingQueue<>();
    final BlockingQueue<String> events = new LinkedBlockingQueue<>();
    final CountDownLatch matched = new CountDownLatch(1);
    private final boolean takes;

    Receiving(boolean takes) {
      this.takes = takes;
    }

    @Override
    public void available(Reader reader) {
      events.add("available");
      if (takes)
        for (Sample each = reader.take(); each != null; each = reader.take()) samples.add(each);
    }

    @Override
    public void matched(Reader reader, EndpointInfo writer) {
      matched.countDown();
      events.add("matched");
    }

    @Override
    public void unmatched(Reader reader, Guid writer) {
      events.add("unmatched");
    }

    @Override
    public void hindered(Reader reader, EndpointInfo writer, String policy) {
      events.add(policy);
    }

    @Override
    public void liveliness(Reader reader, Guid writer, boolean alive) {
      events.add(alive ? "alive" : "not alive");
    }

    @Override
    public void deadlineMissed(Reader reader) {
      events.add("deadline");
    }

    void awaitMatched() throws InterruptedException {
      Awaited.zero(matched, "no writer");
    }

    /** The next sample. */
    Sample next() throws InterruptedException {
      return Awaited.next(samples, events);
    }

    void await(String event) throws InterruptedException {
      List<String> seen = new ArrayList<>();
      while (!seen.contains(event)) seen.add(Awaited.next(events, event + " not among " + seen));
    }
  }

  /** A payload that begins with its number. */
  static ByteBuffer payload(int number, int size) {
    ByteBuffer bytes = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putInt(0, 0x00000100).putInt(4, number);
    for (int i = 8; i < size; i++) bytes.put(i, (byte) (number + i / 1000));
    return bytes;
  }

  /** Whether it is that payload, as a receiver sees it: possibly with padding. */
  static boolean isPayload(ByteBuffer bytes, int number, int size) {
    return bytes.remaining() >= size && bytes.slice(0, size).equals(payload(number, size));
  }

  static Duration millis(long count) {
    return Duration.ofMillis(count);
  }
}
