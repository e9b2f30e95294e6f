package org.urbi.bench.ros;

import static org.urbi.bench.ros.RosPeer.say;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.InterfaceFiles;
import org.urbi.ros.rtps.EndpointInfo;
import org.urbi.ros.rtps.EndpointQos;
import org.urbi.ros.rtps.Participant;
import org.urbi.ros.rtps.ParticipantListener;
import org.urbi.ros.rtps.ParticipantOptions;
import org.urbi.ros.rtps.Reader;
import org.urbi.ros.rtps.ReaderListener;
import org.urbi.ros.rtps.Writer;
import org.urbi.ros.rtps.WriterListener;
import urbi.UDictionary;

/**
 * What carries ROS 2, without its nodes, for {@code bench/ros2}: {@code publish WHAT SIZE SECONDS}
 * on the topic that {@link RosPeer} has, as fast as readers take it, {@code WHAT} being {@code
 * bytes} or {@code messages}, which are written as bytes each time; {@code subscribe SECONDS WARM};
 * {@code ping SIZE COUNT} and {@code pong}.
 */
public final class WireBench {
  private static final String TYPE = "std_msgs::msg::dds_::String_";
  private static final EndpointQos ALL = EndpointQos.reliable(EndpointQos.KEEP_ALL);
  private static final byte[] NO_DATA = {};

  private final Participant participant;

  private WireBench(Participant participant) {
    this.participant = participant;
  }

  public static void main(String[] arguments) throws IOException, InterruptedException {
    int domain = Integer.parseInt(System.getenv("ROS_DOMAIN_ID"));
    try (Participant participant =
        Participant.open(ParticipantOptions.loopback(domain), ParticipantListener.NONE)) {
      WireBench bench = new WireBench(participant);
      int[] numbers =
          Arrays.stream(arguments)
              .filter(each -> Character.isDigit(each.charAt(0)))
              .mapToInt(Integer::parseInt)
              .toArray();
      switch (arguments[0]) {
        case "publish" ->
            bench.publish(
                arguments[1].equals("messages") ? messages(numbers[0]) : bytes(numbers[0]),
                numbers[1]);
        case "subscribe" -> bench.subscribe(numbers[0], numbers[1]);
        case "ping" -> bench.ping(numbers[0], numbers[1]);
        case "pong" -> bench.pong();
        default -> throw new IllegalArgumentException(arguments[0]);
      }
    }
  }

  private static Supplier<ByteBuffer> messages(int size) {
    MessageCodec codec =
        MessageCodec.of(
            new Definitions(Dialect.ROS_2, InterfaceFiles.of(Dialect.ROS_2, System.getenv()))
                .message("std_msgs/String"));
    UDictionary message = new UDictionary().with("data", "x".repeat(size));
    return () -> ByteBuffer.wrap(codec.encode(message));
  }

  private static Supplier<ByteBuffer> bytes(int size) {
    byte[] bytes = messages(size).get().array();
    return () -> ByteBuffer.wrap(bytes);
  }

  /** A writer that somebody hears. */
  private Writer heard(String topic) throws InterruptedException {
    CountDownLatch heard = new CountDownLatch(1);
    Writer writer =
        participant.writer(
            topic,
            TYPE,
            ALL,
            NO_DATA,
            new WriterListener() {
              @Override
              public void matched(Writer us, EndpointInfo reader) {
                heard.countDown();
              }
            });
    heard.await();
    return writer;
  }

  private void publish(Supplier<ByteBuffer> source, int seconds) throws InterruptedException {
    Writer writer = heard("rt/bench");
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
    while (System.nanoTime() < end) {
      ByteBuffer next = source.get();
      while (writer.write(next) == 0 && writer.awaitRoom(TimeUnit.SECONDS.toNanos(1))) {}
    }
  }

  private Reader reader(String topic, ReaderListener listener) {
    return participant.reader(topic, TYPE, ALL, NO_DATA, listener);
  }

  private void subscribe(int seconds, int warm) throws InterruptedException {
    AtomicLong count = new AtomicLong();
    CountDownLatch begun = new CountDownLatch(1);
    reader(
        "rt/bench",
        new ReaderListener() {
          @Override
          public void available(Reader us) {
            for (var some = us.take(100); !some.isEmpty(); some = us.take(100)) {
              count.addAndGet(some.size());
            }
            begun.countDown();
          }
        });
    say("ready");
    begun.await();
    // What it does first is not what it does all the time.
    Thread.sleep(warm * 1000L);
    long before = count.get();
    long from = System.nanoTime();
    Thread.sleep(seconds * 1000L);
    say("%.0f".formatted((count.get() - before) / ((System.nanoTime() - from) / 1e9)));
  }

  /** Prints the median of round trips, in microseconds. */
  private void ping(int size, int count) throws InterruptedException {
    Supplier<ByteBuffer> source = bytes(size);
    long[] times = new long[2 * count];
    CountDownLatch done = new CountDownLatch(times.length);
    Writer ping = heard("rt/ping");
    reader(
        "rt/pong",
        new ReaderListener() {
          @Override
          public void available(Reader us) {
            us.take();
            int next = times.length - (int) done.getCount();
            times[next] = System.nanoTime() - times[next];
            if (next + 1 < times.length) {
              times[next + 1] = System.nanoTime();
              ping.write(source.get());
            }
            done.countDown();
          }
        });
    // The other one may hear before it is heard.
    Thread.sleep(1000);
    times[0] = System.nanoTime();
    ping.write(source.get());
    done.await();
    Arrays.sort(times, count, times.length);
    say("%.1f".formatted(times[count + count / 2] / 1e3));
  }

  private void pong() throws InterruptedException {
    Writer pong = participant.writer("rt/pong", TYPE, ALL, NO_DATA, new WriterListener() {});
    reader(
        "rt/ping",
        new ReaderListener() {
          @Override
          public void available(Reader us) {
            for (var each = us.take(); each != null; each = us.take()) {
              pong.write(each.payload());
            }
          }
        });
    say("ready");
    Thread.sleep(Long.MAX_VALUE);
  }
}
