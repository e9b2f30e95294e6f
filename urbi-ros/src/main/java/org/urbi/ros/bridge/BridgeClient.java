package org.urbi.ros.bridge;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Node;
import urbi.thread.GuardedThreads;

/** One client: what it asks for is done one after the other; what it hears, it hears meanwhile. */
final class BridgeClient implements AutoCloseable {
  private final WebSocket socket;
  private final Outbox outbox = new Outbox();
  private final Replies replies;
  private final Topics topics;
  private final Services services;
  private final Goals goals;
  private final OfferedActions actions;
  private final Fragments fragments = new Fragments();

  BridgeClient(Node node, WebSocket socket) {
    this.socket = socket;
    replies = new Replies(outbox, this::letGo);
    topics = new Topics(node, replies);
    services = new Services(node, replies);
    goals = new Goals(node, replies);
    actions = new OfferedActions(node, replies);
  }

  private void letGo() {
    try {
      socket.close();
    } catch (IOException e) {
      // It has gone by itself.
    }
  }

  /**
   * Serves it until it goes.
   *
   * @throws IOException why, unless it has said good-bye
   */
  void run() throws IOException {
    Thread writer =
        GuardedThreads.SDK.virtual("urbi-ros-bridge-out", this::write, defect -> letGo());
    try (this) {
      writer.start();
      for (String text = socket.read(); text != null; text = socket.read()) {
        obey(text);
      }
    } finally {
      writer.interrupt();
    }
  }

  private void write() {
    try {
      for (WebSocket.Frame next = outbox.take(); next != null; next = outbox.take()) {
        socket.send(next);
      }
    } catch (IOException e) {
      // The one who reads notices.
      letGo();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void obey(@Nullable String text) {
    String next = text;
    while (next != null) {
      Operation operation;
      try {
        operation = new Operation(JsonReader.object(next));
      } catch (BridgeException e) {
        replies.status("error", String.valueOf(e.getMessage()), null);
        return;
      }
      next = null;
      try {
        if (operation.text("op").equals("fragment")) {
          next = fragments.add(operation);
        } else {
          obey(operation);
        }
      } catch (RuntimeException | Error e) {
        replies.failed(operation, e);
      }
    }
  }

  private void obey(Operation operation) {
    switch (operation.text("op")) {
      case "advertise" -> topics.advertise(operation);
      case "unadvertise" -> topics.unadvertise(operation);
      case "publish" -> topics.publish(operation);
      case "subscribe" -> topics.subscribe(operation);
      case "unsubscribe" -> topics.unsubscribe(operation);
      case "call_service" -> services.call(operation);
      case "advertise_service" -> services.advertise(operation);
      case "unadvertise_service" -> services.unadvertise(operation);
      case "service_response" -> services.respond(operation);
      case "send_action_goal" -> goals.send(operation);
      case "cancel_action_goal" -> goals.cancel(operation);
      case "advertise_action" -> actions.advertise(operation);
      case "unadvertise_action" -> actions.unadvertise(operation);
      case "action_feedback" -> actions.feedback(operation);
      case "action_result" -> actions.end(operation);
      case "set_level" -> replies.setLevel(operation.needed("level"));
      case "" -> throw new BridgeException("'op' is missing");
      default -> throw new BridgeException("there is no such operation");
    }
  }

  @Override
  public void close() {
    outbox.close();
    topics.close();
    services.close();
    goals.close();
    actions.close();
    letGo();
  }
}
