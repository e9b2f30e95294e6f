package org.urbi.bench.ros;

import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.one.OneNode;
import org.urbi.ros.one.OneSettings;
import org.urbi.ros.rcl.Middleware;
import org.urbi.ros.two.TwoSettings;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UValue;

/**
 * Urbi's half of {@code bench/ros}, with the same arguments as {@code native/ros_peer.cc} and
 * {@code native/ros_peer.py}: {@code publish TYPE SIZE SECONDS}, {@code subscribe TYPE SECONDS
 * [WARM]}, {@code serve}, {@code call COUNT}. For {@code bench/ros2}, where {@code ROS_VERSION} is
 * 2, also what {@link TopicBench} and {@link StayBench} have.
 */
public final class RosPeer {
  private static final String TOPIC = "/bench";
  private static final String SERVICE = "/flip";

  /** When this program began. */
  static final long BEGUN = System.nanoTime();

  private final Node node;

  private RosPeer(Node node) {
    this.node = node;
  }

  public static void main(String[] arguments) throws Exception {
    try (Node node = node()) {
      RosPeer peer = new RosPeer(node);
      switch (arguments[0]) {
        case "publish" ->
            peer.publish(
                arguments[1], Integer.parseInt(arguments[2]), Double.parseDouble(arguments[3]));
        case "subscribe" ->
            peer.subscribe(
                arguments[1],
                Double.parseDouble(arguments[2]),
                arguments.length > 3 ? Double.parseDouble(arguments[3]) : 1);
        case "serve" -> peer.serve();
        case "call" -> peer.call(Integer.parseInt(arguments[1]));
        case "stay" -> StayBench.run(node, Arrays.copyOfRange(arguments, 1, arguments.length));
        default -> TopicBench.run(node, arguments);
      }
    }
  }

  private static Node node() {
    String name = "bench_" + ProcessHandle.current().pid();
    return "2".equals(System.getenv("ROS_VERSION"))
        ? Middleware.start(
            System.getenv(), TwoSettings.of(System.getenv(), name, Map.of()), System.err::println)
        : OneNode.start(OneSettings.of(System.getenv(), name, Map.of()), present -> {});
  }

  static void say(String text) {
    System.out.println(text);
    System.out.flush();
  }

  private void publish(String name, int size, double seconds) throws InterruptedException {
    MessageType type = node.definitions().message(name);
    UDictionary message = Templates.of(type);
    message.put(
        "data",
        name.endsWith("String")
            ? new UValue("x".repeat(size))
            : new UValue(new UBinary(new byte[size])));
    CountDownLatch heard = new CountDownLatch(1);
    try (Publisher publisher =
        node.advertise(
            TOPIC,
            type,
            new Qos(true, false, size > 100_000 ? 20 : 20_000, Qos.DEFAULT.deadline(), false),
            new Publisher.Listener() {
              @Override
              public void connected(String other) {
                heard.countDown();
              }
            })) {
      heard.await();
      long end = System.nanoTime() + (long) (seconds * 1e9);
      while (System.nanoTime() < end) {
        publisher.publish(message);
      }
    }
  }

  private void subscribe(String name, double seconds, double warm) throws InterruptedException {
    AtomicInteger count = new AtomicInteger();
    CountDownLatch begun = new CountDownLatch(1);
    node.subscribe(
        TOPIC,
        node.definitions().message(name),
        new Qos(true, false, 0, Qos.DEFAULT.deadline(), false),
        message -> {
          count.incrementAndGet();
          begun.countDown();
        });
    say("ready");
    begun.await();
    // What it does first is not what it does all the time.
    Thread.sleep((long) (warm * 1000));
    int before = count.get();
    long from = System.nanoTime();
    Thread.sleep((long) (seconds * 1000));
    say("%.0f".formatted((count.get() - before) / ((System.nanoTime() - from) / 1e9)));
  }

  private void serve() throws InterruptedException {
    var type = node.definitions().service("std_srvs/SetBool");
    node.serve(
        SERVICE,
        type,
        request ->
            java.util.concurrent.CompletableFuture.completedFuture(Templates.of(type.response())));
    node.settled().join();
    say("ready");
    Thread.sleep(Long.MAX_VALUE);
  }

  private void call(int count) {
    try (ServiceClient client = node.client(SERVICE, null, true).join()) {
      UDictionary request = Templates.of(client.type().request());
      for (int i = 0; i < count; i++) {
        client.request(request).join();
      }
      long from = System.nanoTime();
      for (int i = 0; i < count; i++) {
        client.request(request).join();
      }
      say("%.1f".formatted((System.nanoTime() - from) / 1e3 / count));
    }
  }
}
