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
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
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

  private static final String INTERRUPT_ANYBODY =
      new String(OperatorRequest.bytes(""), StandardCharsets.ISO_8859_1);

  /** Questions of telnet and requests of operators are cheap, and the answers want memory, too. */
  @ParameterizedTest
  @MethodSource("questions")
  void clientThatAsksWithoutEndAndReadsNoAnswerIsDisconnected(String question) {
    EmbeddedChannel channel =
        new EmbeddedChannel(new Stuck(), new TelnetDecoder(handler::output), handler);
    int asked = 0;
    while (channel.isOpen() && asked < 1000) {
      channel.writeInbound(bytes(question));
      channel.runPendingTasks();
      asked++;
    }
    assertFalse(channel.isOpen());
    assertEquals(List.of("close"), lobby.calls);
    String said = log.toString(StandardCharsets.UTF_8);
    assertTrue(said.contains("does not read"), said);
  }

  static Stream<String> questions() {
    return Stream.of("\u00ff\u00f6", "\u00ff\u00fd\u0001", "\u00ff\u00fb\u0003", INTERRUPT_ANYBODY);
  }

  @Test
  void nothingIsDoneForWhoIsLetGo() {
    EmbeddedChannel channel =
        new EmbeddedChannel(new Stuck(), new TelnetDecoder(handler::output), handler);
    channel.writeInbound(bytes(INTERRUPT_ANYBODY.repeat(10_000)));
    channel.runPendingTasks();
    assertFalse(channel.isOpen());
    assertTrue(lobby.requests < 100, "requests: " + lobby.requests);
  }

  /** In one piece with much else, and all of them read. */
  @Test
  void whoeverReadsTheAnswersStaysConnected() {
    EmbeddedChannel channel = new EmbeddedChannel(new TelnetDecoder(handler::output), handler);
    for (int i = 0; i < 10; ++i) {
      channel.writeInbound(bytes("\u00ff\u00f6".repeat(1000)));
      assertEquals(7000, sent(channel).length());
    }
    channel.writeInbound(bytes(INTERRUPT_ANYBODY));
    assertEquals("[00000000" + OperatorRequest.ANSWER + "asked for \n", sent(channel));
    assertTrue(channel.isOpen());
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
