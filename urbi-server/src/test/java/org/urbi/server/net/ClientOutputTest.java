package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.buffer.ByteBuf;
import io.netty.channel.EventLoop;
import io.netty.channel.embedded.EmbeddedChannel;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class ClientOutputTest {
  /** How many times there is no memory to give the network thread something to do. */
  private int wanting;

  private final EmbeddedChannel channel =
      new EmbeddedChannel() {
        @Override
        public EventLoop eventLoop() {
          EventLoop own = super.eventLoop();
          return (EventLoop)
              Proxy.newProxyInstance(
                  EventLoop.class.getClassLoader(),
                  new Class<?>[] {EventLoop.class},
                  (proxy, method, arguments) -> {
                    if (method.getName().equals("execute") && wanting-- > 0) {
                      throw new OutOfMemoryError();
                    }
                    try {
                      return method.invoke(own, arguments);
                    } catch (InvocationTargetException e) {
                      throw e.getCause();
                    }
                  });
        }
      };

  private final TotalOutput total = new TotalOutput(1000);
  private final ClientOutput output = new ClientOutput(channel, 1000, total, () -> {});

  private String sent() {
    channel.runPendingTasks();
    StringBuilder text = new StringBuilder();
    for (ByteBuf out = channel.readOutbound(); out != null; out = channel.readOutbound()) {
      text.append(out.toString(StandardCharsets.ISO_8859_1));
      out.release();
    }
    return text.toString();
  }

  @Test
  void whatWaitsIsSentTogether() {
    output.add("one ");
    output.add("two");
    assertEquals(7, output.unsent());
    assertEquals("one two", sent());
    assertEquals(0, output.unsent());
  }

  /** The kernel keeps what it could not add, and adds it again. */
  @Test
  void whatCannotBeSentForWantOfMemoryIsRefused() {
    wanting = 1;
    assertThrows(OutOfMemoryError.class, () -> output.add("one"));
    assertEquals(0, output.unsent());
    assertEquals("", sent());
    output.add("one");
    assertEquals("one", sent());
  }

  /** It would be copied for nothing, again and again. */
  @Test
  void whatTheSocketDoesNotTakeGoesOnWaiting() {
    output.add("one ");
    assertEquals("one ", sent());
    channel.unsafe().outboundBuffer().setUserDefinedWritability(1, false);
    output.add("two ");
    output.finish();
    assertEquals("", sent());
    assertTrue(channel.isOpen());
    channel.unsafe().outboundBuffer().setUserDefinedWritability(1, true);
    output.resume();
    assertEquals("two ", sent());
    assertFalse(channel.isOpen());
  }
}
