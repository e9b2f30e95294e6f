package org.urbi.bench.clients;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Clients of one server, all on the thread that calls. */
final class Crowd implements AutoCloseable {
  private static final int BUFFER = 4096;
  private static final long NANOSECONDS_PER_SECOND = 1_000_000_000;
  private static final long ANSWER_SECONDS = 60;

  private final InetSocketAddress address;
  private final Selector selector = Selector.open();
  private final List<Member> members = new ArrayList<>();
  private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER);

  /** One of them: it asks, waits for a whole line, and asks again. */
  private static final class Member {
    final SocketChannel socket;
    long asked;
    long connected;
    int answers;

    Member(SocketChannel socket) {
      this.socket = socket;
    }
  }

  /** What the busy ones have got: times in nanoseconds, sorted; answers of each, sorted. */
  record Busy(long[] times, int[] answers, double seconds) {}

  Crowd(int port) throws IOException {
    address = new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
  }

  /**
   * Connects so many more at once, each of which asks one thing.
   *
   * @return how long each has taken from its start until its first answer, sorted, in nanoseconds
   */
  long[] connect(int count, String question) throws IOException {
    byte[] text = question.getBytes(StandardCharsets.ISO_8859_1);
    List<Member> more = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      SocketChannel socket = SocketChannel.open();
      socket.configureBlocking(false);
      socket.setOption(StandardSocketOptions.TCP_NODELAY, true);
      Member member = new Member(socket);
      member.connected = System.nanoTime();
      int interest = socket.connect(address) ? SelectionKey.OP_READ : SelectionKey.OP_CONNECT;
      socket.register(selector, interest, member);
      if (interest == SelectionKey.OP_READ) {
        socket.write(ByteBuffer.wrap(text));
      }
      more.add(member);
    }
    members.addAll(more);
    long[] times = new long[count];
    int done = 0;
    long end = System.nanoTime() + ANSWER_SECONDS * NANOSECONDS_PER_SECOND;
    while (done < count) {
      for (Member member : ready(end)) {
        if (member.socket.isConnectionPending()) {
          member.socket.finishConnect();
          member.socket.register(selector, SelectionKey.OP_READ, member);
          member.socket.write(ByteBuffer.wrap(text));
        } else if (hasAnswer(member)) {
          times[done++] = System.nanoTime() - member.connected;
        }
      }
    }
    Arrays.sort(times);
    return times;
  }

  /** The first so many ask one thing after the other for so long. */
  Busy ask(int count, String question, int seconds) throws IOException {
    byte[] text = question.getBytes(StandardCharsets.ISO_8859_1);
    List<Member> busy = members.subList(0, count);
    List<Long> times = new ArrayList<>();
    long began = System.nanoTime();
    for (Member member : busy) {
      member.answers = 0;
      ask(member, text);
    }
    long end = began + seconds * NANOSECONDS_PER_SECOND;
    long patience = end + ANSWER_SECONDS * NANOSECONDS_PER_SECOND;
    int waiting = count;
    while (waiting > 0) {
      for (Member member : ready(patience)) {
        if (hasAnswer(member)) {
          long now = System.nanoTime();
          times.add(now - member.asked);
          member.answers++;
          if (now < end) {
            ask(member, text);
          } else {
            waiting--;
          }
        }
      }
    }
    double passed = (System.nanoTime() - began) / (double) NANOSECONDS_PER_SECOND;
    return new Busy(
        times.stream().mapToLong(Long::longValue).sorted().toArray(),
        busy.stream().mapToInt(member -> member.answers).sorted().toArray(),
        passed);
  }

  private static void ask(Member member, byte[] text) throws IOException {
    member.asked = System.nanoTime();
    member.socket.write(ByteBuffer.wrap(text));
  }

  private List<Member> ready(long end) throws IOException {
    if (System.nanoTime() > end) {
      throw new IOException("no answer for " + ANSWER_SECONDS + " s");
    }
    selector.select(1000);
    List<Member> ready = new ArrayList<>();
    for (SelectionKey key : selector.selectedKeys()) {
      ready.add((Member) key.attachment());
    }
    selector.selectedKeys().clear();
    return ready;
  }

  /** Whether a whole line is there. Answers are short. */
  private boolean hasAnswer(Member member) throws IOException {
    buffer.clear();
    int count = member.socket.read(buffer);
    if (count < 0) {
      throw new IOException("the server has hung up");
    }
    return count > 0 && buffer.get(count - 1) == '\n';
  }

  @Override
  public void close() throws IOException {
    for (Member member : members) {
      member.socket.close();
    }
    selector.close();
  }
}
