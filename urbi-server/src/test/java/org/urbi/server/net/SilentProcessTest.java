package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufUtil;
import io.netty.buffer.Unpooled;
import io.netty.channel.embedded.EmbeddedChannel;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.server.Trace;
import urbi.wire.Frame;
import urbi.wire.Protocol;

/** A process with UObjects that is connected, and says nothing any more. */
class SilentProcessTest {
  private static final byte[] PING = {0, 0, 0, 1, (byte) Frame.PING};
  private static final byte[] PONG = {0, 0, 0, 1, (byte) Frame.PONG};

  private final Kernel kernel = Kernel.builder().start();
  private EmbeddedChannel channel;

  @BeforeEach
  void connect() {
    Trace trace =
        new Trace(
            Trace.Level.NONE,
            new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));
    channel = new EmbeddedChannel();
    channel.freezeTime();
    channel
        .pipeline()
        .addLast(
            new FrameHandler(
                kernel::connectRemote,
                new DatagramPort(channel.eventLoop(), () -> null, trace),
                trace));
  }

  @AfterEach
  void end() {
    channel.close();
    kernel.close();
  }

  private void pass(int seconds) {
    for (int i = 0; i < seconds; i++) {
      channel.advanceTimeBy(1, TimeUnit.SECONDS);
      channel.runScheduledPendingTasks();
      channel.runPendingTasks();
    }
  }

  private byte[] sent() {
    ByteBuf out = channel.readOutbound();
    try {
      return out == null ? null : ByteBufUtil.getBytes(out);
    } finally {
      if (out != null) {
        out.release();
      }
    }
  }

  @Test
  void silentPeerIsProbedAndThenDisconnected() {
    pass(Protocol.SILENCE_SECONDS - 1);
    assertNull(sent());
    pass(1);
    assertArrayEquals(PING, sent());
    pass(Protocol.TIMEOUT_SECONDS - Protocol.SILENCE_SECONDS - 1);
    assertTrue(channel.isActive());
    pass(1);
    assertFalse(channel.isActive());
  }

  @Test
  void peerThatAnswersStaysConnected() {
    for (int i = 0; i < 10; i++) {
      pass(Protocol.TIMEOUT_SECONDS - 1);
      channel.writeInbound(Unpooled.wrappedBuffer(PONG));
    }
    assertTrue(channel.isActive());
  }
}
