package org.urbi.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.channel.embedded.EmbeddedChannel;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Connections from which nothing whole comes, in virtual time. */
class SilenceTest {
  private static final int SECONDS = 10;
  private static final String UPGRADE =
      "GET /stream HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
          + "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
  private static final byte PING = (byte) 0x89;

  private final EmbeddedChannel channel = new EmbeddedChannel();

  @BeforeEach
  void serve() {
    channel.freezeTime();
    Page page = new Page(SilenceTest.class, 1000, SECONDS, new WriteBufferWaterMark(100, 1000));
    PagePort.serve(
        channel,
        page,
        new PageFiles(
            page,
            new PageShelf(),
            new HostNames(true, "localhost", true),
            false,
            new Downloads(channel.eventLoop(), new Places()),
            ChannelInboundHandlerAdapter::new,
            null,
            null));
  }

  @AfterEach
  void close() {
    channel.finishAndReleaseAll();
  }

  private void hear(byte... bytes) {
    channel.writeInbound(Unpooled.wrappedBuffer(bytes));
  }

  private void pass(int seconds) {
    channel.advanceTimeBy(seconds, TimeUnit.SECONDS);
    channel.runPendingTasks();
  }

  /** The first byte of the next thing that has been sent, which is a frame. */
  private byte nextFrame() {
    ByteBuf frame = assertInstanceOf(ByteBuf.class, channel.readOutbound());
    try {
      return frame.getByte(0);
    } finally {
      frame.release();
    }
  }

  @Test
  void whoSaysNothingIsClosed() {
    pass(SECONDS - 1);
    assertTrue(channel.isOpen());
    pass(1);
    assertFalse(channel.isOpen());
  }

  @Test
  void halfRequestThatGrowsIsNothing() {
    for (int second = 1; second < SECONDS; second++) {
      hear((byte) 'G');
      pass(1);
      assertTrue(channel.isOpen());
    }
    hear((byte) 'G');
    pass(1);
    assertFalse(channel.isOpen());
  }

  @Test
  void streamIsAskedFirst() {
    hear(UPGRADE.getBytes(StandardCharsets.US_ASCII));
    ByteBuf answer = channel.readOutbound();
    assertTrue(answer.toString(StandardCharsets.US_ASCII).startsWith("HTTP/1.1 101"));
    answer.release();
    for (int round = 0; round < 3; round++) {
      pass(SECONDS);
      assertTrue(channel.isOpen());
      assertEquals(PING, nextFrame());
      // A pong, with a mask, as browsers send it.
      hear((byte) 0x8a, (byte) 0x80, (byte) 1, (byte) 2, (byte) 3, (byte) 4);
    }
    pass(SECONDS);
    assertEquals(PING, nextFrame());
    pass(SECONDS);
    assertFalse(channel.isOpen());
  }
}
