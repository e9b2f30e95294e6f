package org.urbi.ros.rcl;

import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.two.TwoSettings;

/** A program that ends while its node still hears: {@code DOMAIN INSTALLATION}. */
final class EndsWithoutClosing {
  private EndsWithoutClosing() {}

  public static void main(String[] arguments) throws InterruptedException {
    Node node =
        Middleware.start(
            Map.of(
                "URBI_ROS_MIDDLEWARE",
                "rcl",
                "AMENT_PREFIX_PATH",
                Path.of(arguments[1]).toString()),
            TwoSettings.of(Map.of("ROS_DOMAIN_ID", arguments[0]), "ends", Map.of()),
            System.err::println);
    MessageType type = node.definitions().message("std_msgs/String");
    CountDownLatch heard = new CountDownLatch(1);
    node.subscribe("x", type, Qos.LATCHED, message -> heard.countDown());
    heard.await();
    System.exit(7);
  }
}
