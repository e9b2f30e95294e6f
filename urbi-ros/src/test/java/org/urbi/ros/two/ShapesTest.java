package org.urbi.ros.two;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.rtps.Peer;

/** Messages of every shape: from nodes of two distributions to us, as Dictionaries, and back. */
class ShapesTest {
  private static final Qos KEPT = new Qos(true, true, 10, Qos.DEFAULT.deadline(), false);

  private final BlockingQueue<String> told = new LinkedBlockingQueue<>();

  @ParameterizedTest
  @ValueSource(strings = {"kilted", "jazzy"})
  void comeBackAsTheyWere(String environment) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = Peer.of(environment, domain.domain(), "shapes.py");
        TwoNode node =
            TwoNode.start(
                TwoSettings.of(
                    Map.of(
                        "ROS_DOMAIN_ID",
                        "" + domain.domain(),
                        "AMENT_PREFIX_PATH",
                        Peer.prefix(environment)),
                    "mirror",
                    Map.of()),
                told::add)) {
      List<String> names = shapes(Path.of(Peer.prefix(environment)));
      assertTrue(
          names.containsAll(List.of("Arrays", "BoundedSequences", "WStrings")), () -> "" + names);
      for (String name : names) {
        MessageType type = node.definitions().message("test_msgs/" + name);
        Publisher back = node.advertise("/back/" + name, type, KEPT, new Publisher.Listener() {});
        node.subscribe("/there/" + name, type, KEPT, back::publish);
      }
      peer.say(String.join(" ", names));
      peer.expectInAnyOrder(names.stream().map(name -> name + " same").toArray(String[]::new));
      assertTrue(told.isEmpty(), told::toString);
      peer.kill();
    }
  }

  private static List<String> shapes(Path prefix) throws Exception {
    try (Stream<Path> files = Files.list(prefix.resolve("share/test_msgs/msg"))) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(".msg"))
          .map(name -> name.substring(0, name.length() - ".msg".length()))
          .sorted()
          .toList();
    }
  }
}
