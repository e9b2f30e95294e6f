package org.urbi.ros.one;

import java.net.URI;
import java.util.List;

/** What masters and other nodes may ask of this one. */
final class SlaveMethods implements XmlRpcServer.Handler {
  private static final int DONE = 1;
  private static final int FAILED = 0;

  private final OneNode node;

  SlaveMethods(OneNode node) {
    this.node = node;
  }

  private static List<Object> done(Object value) {
    return List.of(DONE, "", value);
  }

  @Override
  public List<?> call(String method, List<Object> arguments) {
    return switch (method) {
      case "getPid" -> done((int) ProcessHandle.current().pid());
      case "getName" -> done(node.name());
      case "getMasterUri" -> done(node.masterUri());
      case "getSubscriptions" -> done(node.subscribed());
      case "getPublications" -> done(node.published());
      case "getBusStats" -> done(List.of(List.of(), List.of(), List.of()));
      case "getBusInfo" -> done(List.of());
      case "publisherUpdate" -> {
        List<URI> publishers =
            ((List<?>) arguments.get(2)).stream().map(each -> URI.create((String) each)).toList();
        node.updatePublishers((String) arguments.get(1), publishers);
        yield done(0);
      }
      case "paramUpdate" -> {
        node.updateParameter((String) arguments.get(1), arguments.get(2));
        yield done(0);
      }
      case "requestTopic" -> requestTopic((String) arguments.get(1), (List<?>) arguments.get(2));
      case "shutdown" -> List.of(FAILED, "urbi ends when urbiscript says so", 0);
      default -> throw new IllegalArgumentException("no such method: " + method);
    };
  }

  private List<?> requestTopic(String topic, List<?> protocols) {
    if (node.publication(topic) == null) {
      return List.of(FAILED, node.name() + " does not publish " + topic, 0);
    }
    boolean tcp =
        protocols.stream()
            .anyMatch(each -> each instanceof List<?> list && list.contains("TCPROS"));
    return tcp
        ? done(List.of("TCPROS", node.host(), node.port()))
        : List.of(FAILED, "no protocol but TCPROS is spoken", 0);
  }
}
