package org.urbi.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.channel.embedded.EmbeddedChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** How connections end whose other end goes on, in virtual time. */
class FarewellTest {
  private static final int LONGEST = 1000;
  private static final String HANDSHAKE =
      "GET /stream HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
          + "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";

  private final EmbeddedChannel channel = new EmbeddedChannel();
  private final List<Throwable> thrown = new ArrayList<>();

  @BeforeEach
  void serve() {
    channel.freezeTime();
    Page page = new Page(FarewellTest.class, LONGEST, 10, new WriteBufferWaterMark(100, LONGEST));
    PagePort.serve(
        channel,
        page,
        new PageFiles(
            page,
            new PageShelf(),
            new HostNames(true, "localhost", true),
            false,
            new Downloads(channel.eventLoop(), new Places()),
            this::viewer,
            null,
            null));
  }

  @AfterEach
  void close() {
    channel.finishAndReleaseAll();
  }

  private ChannelInboundHandlerAdapter viewer() {
    return new ChannelInboundHandlerAdapter() {
      @Override
      public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
        thrown.add(cause);
        StreamFailure.close(context, cause, "a page of the test");
      }
    };
  }

  private void hear(String text) {
    channel.writeInbound(Unpooled.copiedBuffer(text, StandardCharsets.ISO_8859_1));
  }

  private void hear(int... bytes) {
    ByteBuf all = Unpooled.buffer();
    for (int each : bytes) {
      all.writeByte(each);
    }
    channel.writeInbound(all);
  }

  private String said() {
    StringBuilder all = new StringBuilder();
    for (ByteBuf next = channel.readOutbound(); next != null; next = channel.readOutbound()) {
      all.append(next.toString(StandardCharsets.ISO_8859_1));
      next.release();
    }
    return all.toString();
  }

  private void connect() {
    hear(HANDSHAKE);
    assertTrue(said().startsWith("HTTP/1.1 101"));
  }

  /** What it goes on to send is taken, up to a limit, and does nothing. */
  private void goesOnInVain() {
    byte[] part = new byte[1 << 16];
    int parts = 0;
    while (channel.isOpen()) {
      channel.writeInbound(Unpooled.wrappedBuffer(part));
      assertTrue(++parts <= Farewell.MOST / part.length + 1, "it is cut off");
    }
    assertEquals("", said());
  }

  @Test
  void tooLongMessageIsToldHowLongItMayBe() {
    connect();
    // A text of 1,001 bytes, with a mask; nothing of it has come yet.
    hear(0x81, 0xfe, 0x03, 0xe9);
    assertEquals("\u0088\u0029\u0003\u00f1a message may have 1000 bytes, not more", said());
    assertInstanceOf(TooLongMessage.class, thrown.getFirst());
    assertTrue(channel.isOpen(), "what is on its way must not take that back");
    goesOnInVain();
    assertEquals(1, thrown.size());
  }

  @Test
  void messageThatIsTooLongInPartsIsToldTheSame() {
    connect();
    for (int i = 0; i < 10; i++) {
      // 125 bytes each, with a mask of zeros: the beginning of a text, and more of it.
      hear(i == 0 ? 0x01 : 0x00, 0xfd, 0, 0, 0, 0);
      hear("x".repeat(125));
    }
    assertTrue(said().endsWith("a message may have 1000 bytes, not more"));
    assertInstanceOf(TooLongMessage.class, thrown.getFirst());
    goesOnInVain();
    assertEquals(1, thrown.size());
  }

  @Test
  void whatIsNoFrameIsTold() {
    connect();
    // There is no kind 3 of frames.
    hear(0x83, 0x80, 0, 0, 0, 0);
    assertTrue(said().contains("data frame using reserved opcode 3"));
    assertEquals(List.of(), thrown);
    goesOnInVain();
  }

  @Test
  void textThatIsNoTextIsTold() {
    connect();
    hear(0x81, 0x81, 0, 0, 0, 0, 0xff);
    assertTrue(said().contains("UTF-8"), "invalid data (1007)");
    goesOnInVain();
  }

  @Test
  void requestThatIsTooLongIsCutOff() {
    hear("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000000000\r\n\r\n");
    assertTrue(said().startsWith("HTTP/1.1 413"));
    assertTrue(channel.isOpen(), "what is on its way must not take that back");
    goesOnInVain();
  }

  @Test
  void requestInPartsThatIsTooLongIsCutOff() {
    hear("POST / HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n");
    for (int i = 0; i < 3; i++) {
      assertEquals("", said());
      hear("1000\r\n" + "x".repeat(0x1000) + "\r\n");
    }
    assertTrue(said().startsWith("HTTP/1.1 413"));
    goesOnInVain();
  }

  @Test
  void whoeverDoesNotGoIsCutOff() {
    connect();
    hear(0x81, 0xfe, 0x03, 0xe9);
    channel.advanceTimeBy(Farewell.SECONDS * 1000L - 1, TimeUnit.MILLISECONDS);
    channel.runPendingTasks();
    assertTrue(channel.isOpen());
    channel.advanceTimeBy(1, TimeUnit.MILLISECONDS);
    channel.runPendingTasks();
    assertFalse(channel.isOpen());
  }

  @Test
  void onlyTheFirstReasonIsTold() {
    connect();
    ByteBuf first = Unpooled.copiedBuffer("first", StandardCharsets.US_ASCII);
    ByteBuf second = Unpooled.copiedBuffer("second", StandardCharsets.US_ASCII);
    Farewell.say(channel, first);
    Farewell.say(channel, second);
    assertSame(first, channel.readOutbound());
    assertNull(channel.readOutbound());
    assertEquals(0, second.refCnt());
    first.release();
  }
}
