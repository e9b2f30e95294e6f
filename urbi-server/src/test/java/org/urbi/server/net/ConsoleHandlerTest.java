package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelOutboundHandlerAdapter;
import io.netty.channel.ChannelPromise;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.channel.socket.ChannelInputShutdownEvent;
import io.netty.util.ReferenceCountUtil;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.urbi.server.Trace;

class ConsoleHandlerTest {
  private static final Limits LIMITS = new Limits(100, 50, 1000, 30, 0, "");

  private final RecordingConnection lobby = new RecordingConnection();
  private final ByteArrayOutputStream log = new ByteArrayOutputStream();
  private final ConsoleHandler handler =
      new ConsoleHandler(
          client -> lobby,
          LIMITS,
          new TotalOutput(LIMITS.totalOutput()),
          new Trace(Trace.Level.LOG, new PrintStream(log, true, StandardCharsets.UTF_8)));

  private static ByteBuf bytes(String text) {
    return Unpooled.copiedBuffer(text, StandardCharsets.ISO_8859_1);
  }

  private static String sent(EmbeddedChannel channel) {
    channel.runPendingTasks();
    StringBuilder text = new StringBuilder();
    for (ByteBuf out = channel.readOutbound(); out != null; out = channel.readOutbound()) {
      text.append(out.toString(StandardCharsets.ISO_8859_1));
      out.release();
    }
    return text.toString();
  }

  @Test
  void bytesGoToTheLobbyAndComeBackAsTheyAre() {
    EmbeddedChannel channel = new EmbeddedChannel(handler);
    channel.writeInbound(bytes("\u00ff\0;"));
    assertEquals(List.of("send \u00ff\0;"), lobby.calls);
    handler.output("\u00c3\u00a9\n");
    handler.output("more\n");
    assertEquals("\u00c3\u00a9\nmore\n", sent(channel));
  }

  @Test
  void nothingIsReadWhileTheKernelIsLate() {
    EmbeddedChannel channel = new EmbeddedChannel(handler);
    lobby.pending = 100;
    channel.writeInbound(bytes("1;"));
    assertTrue(channel.config().isAutoRead());
    lobby.pending = 101;
    channel.writeInbound(bytes("1;"));
    assertFalse(channel.config().isAutoRead());
    lobby.pending = 51;
    handler.inputConsumed();
    assertFalse(channel.config().isAutoRead());
    lobby.pending = 50;
    handler.inputConsumed();
    assertTrue(channel.config().isAutoRead());
  }

  @Test
  void inputForWhichThereIsNoMemoryIsPassedOnWhenThereIs() {
    EmbeddedChannel channel = new EmbeddedChannel(handler);
    lobby.failures = 1;
    channel.writeInbound(bytes("1;"));
    channel.writeInbound(bytes("2;"));
    assertEquals(List.of("send 1;", "send 2;"), lobby.calls);
    assertTrue(channel.isOpen());
  }

  /** Then a part of it would be lost, so nothing of the rest may be executed. */
  @Test
  void clientForWhoseInputThereNeverIsMemoryIsDisconnected() {
    EmbeddedChannel channel = new EmbeddedChannel(handler);
    lobby.failures = 2;
    channel.writeInbound(bytes("1;"));
    assertFalse(channel.isOpen());
    assertEquals(List.of("close"), lobby.calls);
  }

  @Test
  void endedInputIsFinishedAndALostClientIsClosed() {
    EmbeddedChannel channel = new EmbeddedChannel(handler);
    channel.pipeline().fireUserEventTriggered(ChannelInputShutdownEvent.INSTANCE);
    channel.pipeline().fireUserEventTriggered(TelnetInterrupt.INSTANCE);
    channel.close();
    assertEquals(List.of("hangUp", "interrupt", "close"), lobby.calls);
  }

  @Test
  void clientThatEndedItsInputIsServedForALimitedTime() {
    EmbeddedChannel channel = new EmbeddedChannel(handler);
    channel.freezeTime();
    channel.pipeline().fireUserEventTriggered(ChannelInputShutdownEvent.INSTANCE);
    channel.advanceTimeBy(29, TimeUnit.SECONDS);
    channel.runScheduledPendingTasks();
    assertEquals(List.of("hangUp"), lobby.calls);
    channel.advanceTimeBy(1, TimeUnit.SECONDS);
    channel.runScheduledPendingTasks();
    channel.runPendingTasks();
    assertEquals(List.of("hangUp", "close"), lobby.calls);
  }

  @Test
  void theLastOutputIsSentBeforeTheConnectionIsClosed() {
    EmbeddedChannel channel = new EmbeddedChannel(handler);
    handler.output("bye\n");
    handler.closed();
    handler.output("too late\n");
    assertEquals("bye\n", sent(channel));
    assertFalse(channel.isOpen());
    channel.runPendingTasks();
    assertEquals(List.of("close"), lobby.calls);
  }

  /** The other end may keep the socket open for seconds. */
  @Test
  void theMemoryOfALobbyThatIsOverDoesNotWaitForTheClientToGo() {
    EmbeddedChannel channel = new EmbeddedChannel(handler);
    assertEquals(lobby, handler.connection());
    handler.closed();
    handler.forgotten();
    assertNull(handler.connection());
    channel.pipeline().fireUserEventTriggered(TelnetInterrupt.INSTANCE);
    channel.runPendingTasks();
    assertFalse(channel.isOpen());
    assertEquals(List.of(), lobby.calls);
  }

  /** A socket whose other end does not read: nothing that is written ever gets out. */
  private static final class Stuck extends ChannelOutboundHandlerAdapter {
    @Override
    public void write(ChannelHandlerContext context, Object message, ChannelPromise promise) {
      ReferenceCountUtil.release(message);
    }
  }

  @Test
  void clientThatDoesNotReadIsDisconnected() {
    EmbeddedChannel channel = new EmbeddedChannel(new Stuck(), handler);
    handler.output("x".repeat(1000));
    channel.runPendingTasks();
    assertTrue(channel.isOpen());
    handler.output("one more");
    channel.runPendingTasks();
    assertFalse(channel.isOpen());
    assertEquals(List.of("close"), lobby.calls);
    handler.output("and another");
    String said = log.toString(StandardCharsets.UTF_8);
    assertEquals(1, said.lines().count(), said);
    assertTrue(said.contains("does not read"), said);
  }

  @Test
  void clientThatReadsStaysConnected() {
    EmbeddedChannel channel = new EmbeddedChannel(handler);
    for (int i = 0; i < 10; ++i) {
      handler.output("x".repeat(1000));
      assertEquals(1000, sent(channel).length());
    }
    assertTrue(channel.isOpen());
  }
}
