package org.urbi.ros;

import java.nio.ByteBuffer;
import java.util.HexFormat;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.urbi.ros.graph.Subscription;
import urbi.UDictionary;

/** Takes messages as their publishers have sent them. */
public final class Lent implements Subscription.Listener {
  private final BlockingQueue<String> messages = new LinkedBlockingQueue<>();

  @Override
  public boolean takes(ByteBuffer sent) {
    byte[] bytes = new byte[sent.remaining()];
    sent.get(bytes);
    messages.add(HexFormat.of().formatHex(bytes));
    return true;
  }

  @Override
  public void received(UDictionary message) {
    messages.add("decoded, too: " + message);
  }

  /** The bytes of the next one, in hexadecimal. */
  public String next() throws InterruptedException {
    return Awaited.next(messages);
  }
}
