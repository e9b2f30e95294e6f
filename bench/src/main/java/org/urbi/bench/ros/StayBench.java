package org.urbi.bench.ros;

import static org.urbi.bench.ros.RosPeer.say;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.message.MessageType;
import urbi.UDictionary;

/**
 * {@code stay PEER…}: hears and speaks while peers come and go, until its input ends. At each line
 * of that it waits until it is alone, and prints what is left of the others.
 */
final class StayBench {
  /** Longer than the lease of any peer, in seconds. */
  private static final int PATIENCE = 60;

  private final Node node;
  private final Publisher publisher;
  private final AtomicInteger[] heard;

  private StayBench(Node node, String[] peers) {
    this.node = node;
    MessageType text = node.definitions().message("std_msgs/String");
    publisher = node.advertise("/stay", text, Qos.DEFAULT, new Publisher.Listener() {});
    heard = new AtomicInteger[peers.length];
    for (int i = 0; i < peers.length; i++) {
      AtomicInteger count = heard[i] = new AtomicInteger();
      node.subscribe("/come_" + peers[i], text, Qos.DEFAULT, message -> count.incrementAndGet());
    }
  }

  static void run(Node node, String[] peers) throws IOException, InterruptedException {
    StayBench bench = new StayBench(node, peers);
    Thread.ofVirtual().start(bench::speak);
    BufferedReader in =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    say("ready");
    while (in.readLine() != null) {
      bench.report();
    }
  }

  private void speak() {
    UDictionary message = new UDictionary().with("data", "x".repeat(1000));
    try {
      while (true) {
        publisher.publish(message);
        Thread.sleep(10);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** {@code left: BYTES THREADS DESCRIPTORS NODES TOPICS HEARD…}. */
  private void report() throws IOException, InterruptedException {
    GraphSnapshot graph = node.graph().join();
    for (int i = 0; i < PATIENCE && !graph.nodes().keySet().equals(Set.of(node.name())); i++) {
      Thread.sleep(1000);
      graph = node.graph().join();
    }
    // What the first one finds is let go by the second.
    System.gc();
    Thread.sleep(1000);
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    long heap = runtime.totalMemory() - runtime.freeMemory();
    StringBuilder line = new StringBuilder("left:");
    line.append(' ').append(heap).append(' ').append(Thread.activeCount());
    line.append(' ').append(descriptors());
    line.append(' ').append(graph.nodes().size()).append(' ').append(graph.topics().size());
    for (AtomicInteger each : heard) {
      line.append(' ').append(each.getAndSet(0));
    }
    say(line.toString());
  }

  private static long descriptors() throws IOException {
    try (Stream<Path> files = Files.list(Path.of("/proc/self/fd"))) {
      return files.count();
    }
  }
}
