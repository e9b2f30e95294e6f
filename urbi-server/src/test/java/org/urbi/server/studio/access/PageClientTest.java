package org.urbi.server.studio.access;

import static org.junit.jupiter.api.Assertions.assertEquals;

import io.netty.channel.ChannelPromise;
import io.netty.channel.embedded.EmbeddedChannel;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.trust.Role;

/** What a lobby says to somebody who does not read it. */
class PageClientTest {
  private static final int MOST = 1 << 18;

  private final EmbeddedChannel channel = new EmbeddedChannel();
  private final List<String> sent = new ArrayList<>();
  private final List<ChannelPromise> unread = new ArrayList<>();
  private final PageClient client =
      new PageClient(
          channel,
          Role.OWNER,
          text -> {
            sent.add(text);
            ChannelPromise written = channel.newPromise();
            unread.add(written);
            return written;
          });

  private void output(String text) {
    client.output(text);
    channel.runPendingTasks();
  }

  private void read() {
    unread.removeFirst().setSuccess();
    channel.runPendingTasks();
  }

  @Test
  void whatIsTooMuchIsLeftOutAndThatIsTold() {
    output("x".repeat(MOST));
    output("lost");
    output("too");
    assertEquals(1, sent.size());
    assertEquals(MOST, client.unread());
    read();
    assertEquals("*** 7 bytes of output are left out: too much at once\n", sent.getLast());
    output("again");
    assertEquals("again", sent.getLast());
    read();
    read();
    assertEquals(List.of(3, 0L), List.of(sent.size(), client.unread()));
  }

  @Test
  void onePieceThatIsTooMuchIsTold() {
    for (int i = 0; i < 3; i++) {
      output("x".repeat(MOST + 1));
    }
    assertEquals(1, sent.size(), "the others wait until that is read");
    read();
    assertEquals(
        "*** " + 2 * (MOST + 1) + " bytes of output are left out: too much at once\n",
        sent.getLast());
  }
}
