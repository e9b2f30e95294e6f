package org.urbi.bench.ros;

import static org.urbi.bench.ros.RosPeer.say;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import urbi.UBinary;
import urbi.UDictionary;

/**
 * What {@code bench/ros2} measures of topics: {@code ping SIZE COUNT} and {@code pong}, {@code send
 * SIZE COUNT RATE} and {@code count COUNT}, {@code many TOPICS RATE SECONDS}, {@code find}.
 */
final class TopicBench {
  private static final String BYTES = "std_msgs/UInt8MultiArray";
  private static final Qos RELIABLE = new Qos(true, false, 1000, Qos.DEFAULT.deadline(), false);

  private final Node node;

  private TopicBench(Node node) {
    this.node = node;
  }

  static void run(Node node, String[] arguments) throws InterruptedException {
    TopicBench bench = new TopicBench(node);
    int[] numbers = Arrays.stream(arguments).skip(1).mapToInt(Integer::parseInt).toArray();
    switch (arguments[0]) {
      case "ping" -> bench.ping(numbers[0], numbers[1]);
      case "pong" -> bench.pong();
      case "send" -> bench.send(numbers[0], numbers[1], numbers[2]);
      case "count" -> bench.count(numbers[0]);
      case "many" -> bench.many(numbers[0], numbers[1], numbers[2]);
      case "find" -> bench.find();
      default -> throw new IllegalArgumentException(arguments[0]);
    }
  }

  private MessageType type(String name) {
    return node.definitions().message(name);
  }

  /** A publisher that somebody hears. */
  private Publisher heard(String topic, String type) throws InterruptedException {
    CountDownLatch heard = new CountDownLatch(1);
    Publisher publisher =
        node.advertise(
            topic,
            type(type),
            RELIABLE,
            new Publisher.Listener() {
              @Override
              public void connected(String other) {
                heard.countDown();
              }
            });
    heard.await();
    return publisher;
  }

  private UDictionary bytes(int size) {
    return Templates.of(type(BYTES)).with("data", new UBinary(new byte[size]));
  }

  private static void waitUntil(long time) throws InterruptedException {
    long left = time - System.nanoTime();
    if (left > 0) {
      Thread.sleep(left / 1_000_000, (int) (left % 1_000_000));
    }
  }

  /** Prints the median of round trips, in microseconds. */
  private void ping(int size, int count) throws InterruptedException {
    Publisher ping = heard("/ping", BYTES);
    UDictionary message = bytes(size);
    long[] times = new long[2 * count];
    CountDownLatch done = new CountDownLatch(times.length);
    node.subscribe(
        "/pong",
        type(BYTES),
        RELIABLE,
        back -> {
          int next = times.length - (int) done.getCount();
          times[next] = System.nanoTime() - times[next];
          if (next + 1 < times.length) {
            times[next + 1] = System.nanoTime();
            ping.publish(message);
          }
          done.countDown();
        });
    // The other one may hear before it is heard.
    Thread.sleep(1000);
    times[0] = System.nanoTime();
    ping.publish(message);
    done.await();
    Arrays.sort(times, count, times.length);
    say("%.1f".formatted(times[count + count / 2] / 1e3));
  }

  private void pong() throws InterruptedException {
    Publisher pong = node.advertise("/pong", type(BYTES), RELIABLE, new Publisher.Listener() {});
    node.subscribe("/ping", type(BYTES), RELIABLE, pong::publish);
    say("ready");
    Thread.sleep(Long.MAX_VALUE);
  }

  private void send(int size, int count, int rate) throws InterruptedException {
    Publisher publisher = heard("/sent", BYTES);
    UDictionary message = bytes(size);
    long due = System.nanoTime();
    for (int i = 0; i < count; i++) {
      publisher.publish(message);
      due += 1_000_000_000L / rate;
      waitUntil(due);
    }
    // What was lost is asked for again.
    Thread.sleep(2000);
  }

  /** Prints how many of so many have come, when all have, or none has for two seconds. */
  private void count(int count) throws InterruptedException {
    BlockingQueue<UDictionary> come = new LinkedBlockingQueue<>();
    node.subscribe("/sent", type(BYTES), RELIABLE, come::add);
    say("ready");
    come.take();
    int got = 1;
    while (got < count && come.poll(2, java.util.concurrent.TimeUnit.SECONDS) != null) {
      got++;
    }
    say("" + got);
  }

  /** Publishes numbers on many topics. */
  private void many(int topics, int rate, int seconds) throws InterruptedException {
    List<Publisher> publishers = new ArrayList<>();
    for (int i = 0; i < topics; i++) {
      publishers.add(
          node.advertise(
              "/many" + i, type("std_msgs/Float64"), RELIABLE, new Publisher.Listener() {}));
    }
    say("ready");
    long due = System.nanoTime();
    for (int i = 0; i < rate * seconds; i++) {
      UDictionary message = new UDictionary().with("data", i);
      publishers.forEach(each -> each.publish(message));
      due += 1_000_000_000L / rate;
      waitUntil(due);
    }
  }

  /** Prints after how many milliseconds it hears somebody who was there before it. */
  private void find() throws InterruptedException {
    CountDownLatch heard = new CountDownLatch(1);
    node.subscribe("/come", type("std_msgs/String"), RELIABLE, message -> heard.countDown());
    heard.await();
    say("%.0f".formatted((System.nanoTime() - RosPeer.BEGUN) / 1e6));
  }
}
