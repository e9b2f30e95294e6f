package org.urbi.ros.one;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.Severity;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/**
 * What a node tells people, on {@code /rosout}; and the services by which they choose how much that
 * is. Every node of ROS 1 has them: they are what makes it appear in the master's graph.
 */
final class RosOut {
  private static final String LOGGER = "urbi";
  private static final Qos KEPT = new Qos(true, false, 100, Qos.DEFAULT.deadline(), false);

  private final OneNode node;
  private final Publisher publisher;
  private volatile Severity least = Severity.INFO;

  RosOut(OneNode node) {
    this.node = node;
    publisher =
        node.advertise(
            "/rosout",
            node.definitions().message("rosgraph_msgs/Log"),
            KEPT,
            new Publisher.Listener() {});
    node.serve(
        "~get_loggers", node.definitions().service("roscpp/GetLoggers"), request -> loggers());
    node.serve(
        "~set_logger_level", node.definitions().service("roscpp/SetLoggerLevel"), this::setLevel);
  }

  private CompletionStage<UDictionary> loggers() {
    UDictionary logger =
        new UDictionary().with("name", LOGGER).with("level", least.name().toLowerCase(Locale.ROOT));
    return CompletableFuture.completedFuture(new UDictionary().with("loggers", UList.of(logger)));
  }

  private CompletionStage<UDictionary> setLevel(UDictionary request) {
    least = Severity.of(field(request, "level").stringValue());
    return CompletableFuture.completedFuture(new UDictionary());
  }

  private static UValue field(UDictionary message, String name) {
    return requireNonNull(message.get(name), "a decoded message has all its fields");
  }

  /** Tells people something. */
  void log(Severity severity, String text) {
    if (severity.compareTo(least) < 0) {
      return;
    }
    UDictionary message = Templates.of(publisher.type());
    field(message, "header").udictionaryValue().put("stamp", Templates.time(node.now()));
    message.put("level", new UValue((double) number(severity)));
    message.put("name", new UValue(node.name()));
    message.put("msg", new UValue(text));
    message.put("topics", new UValue(new UList(List.copyOf(node.publishedNames()))));
    publisher.publish(message);
  }

  /** As {@code rosgraph_msgs/Log} has it. */
  private static int number(Severity severity) {
    return 1 << severity.ordinal();
  }
}
