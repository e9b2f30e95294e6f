package org.urbi.ros.one;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.urbi.ros.Awaited;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.MessageType;
import urbi.UDictionary;

/** What a subscription has heard. */
final class Heard implements Subscription.Listener {
  final BlockingQueue<UDictionary> messages = new LinkedBlockingQueue<>();
  final BlockingQueue<MessageType> types = new LinkedBlockingQueue<>();
  final BlockingQueue<String> failures = new LinkedBlockingQueue<>();

  @Override
  public void received(UDictionary message) {
    messages.add(message);
  }

  @Override
  public void typed(MessageType type) {
    types.add(type);
  }

  @Override
  public void failed(String reason) {
    failures.add(reason);
  }

  /** The text of the next message. */
  String text() throws InterruptedException {
    return Awaited.next(messages, failures).get("data").stringValue();
  }
}
