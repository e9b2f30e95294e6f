package org.urbi.ros.two;

import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.Severity;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;

/** What a node of ROS 2 tells people, on {@code /rosout}. */
final class TwoLog {
  private static final Qos KEPT = new Qos(true, true, 100, Qos.DEFAULT.deadline(), false);

  private final TwoHost node;
  private final Publisher publisher;

  TwoLog(TwoHost node) {
    this.node = node;
    publisher =
        node.advertise(
            "/rosout",
            node.definitions().message("rcl_interfaces/Log"),
            KEPT,
            new Publisher.Listener() {});
  }

  void log(Severity severity, String text) {
    // As in ROS 1, where it is so unless somebody wants to know more.
    if (severity == Severity.DEBUG) return;
    UDictionary message = Templates.of(publisher.type());
    message.put("stamp", Templates.time(node.now()));
    message.put("level", 10.0 * (severity.ordinal() + 1));
    message.put("name", node.name().substring(1).replace('/', '.'));
    message.put("msg", text);
    publisher.publish(message);
  }
}
