package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.channel.socket.ChannelInputShutdownEvent;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.server.Trace;

class ForeignProtocolFilterTest {
  private final ByteArrayOutputStream log = new ByteArrayOutputStream();
  private final Trace trace =
      new Trace(Trace.Level.LOG, new PrintStream(log, true, StandardCharsets.UTF_8));

  private static ByteBuf bytes(String text) {
    return Unpooled.copiedBuffer(text, StandardCharsets.ISO_8859_1);
  }

  private EmbeddedChannel channel() {
    return new EmbeddedChannel(new ForeignProtocolFilter(trace));
  }

  private static String received(EmbeddedChannel channel) {
    StringBuilder text = new StringBuilder();
    for (ByteBuf in = channel.readInbound(); in != null; in = channel.readInbound()) {
      text.append(in.toString(StandardCharsets.ISO_8859_1));
      in.release();
    }
    return text.toString();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "POST / HTTP/1.1\r\nHost: localhost:54000\r\n\r\n\n*/}])>;\n;shutdown;\n",
        "GET /a;shutdown;?b=/*/ HTTP/1.0\r\n\r\n;shutdown;\n",
        "OPTIONS * HTTP/1.1\r\nOrigin: http://elsewhere\r\n\r\n;shutdown;\n",
        "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n;shutdown;\n",
        "\u0016\u0003\u0001\u0002\0\u0001\0\u0001\u00fc\u0003\u0003;shutdown;\n",
        "\0\u0003\0\u0008\u0021\u0012\u00a4\u0042;shutdown;\n",
      })
  void browserRequestsNeverReachTheLobbyWhereverTheyAreCut(String request) {
    for (int cut = 0; cut <= request.length(); cut++) {
      EmbeddedChannel channel = channel();
      channel.writeInbound(bytes(request.substring(0, cut)));
      if (channel.isOpen()) {
        channel.writeInbound(bytes(request.substring(cut)));
      }
      assertEquals("", received(channel), "cut at " + cut);
      assertFalse(channel.isOpen(), "cut at " + cut);
      assertTrue(log.toString(StandardCharsets.UTF_8).contains("client refused, it speaks"));
      ByteBuf answer = channel.readOutbound();
      assertTrue(answer.toString(StandardCharsets.ISO_8859_1).contains("closing\n"));
      answer.release();
      channel.finishAndReleaseAll();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "1;\n",
        "\n",
        "POST;\n",
        "GET / 2;\nHTTP/1;\n",
        "GET + x HTTP;\n",
        "PUT (1) HTTP(2);\n",
        "getSlot(\"x\");\n",
        "HEADING = 2;\n",
        "echo(\"GET / HTTP/1.1\");\n",
        "\u00ff\u00fb\u001f1;\n",
        "\0;1;\n",
      })
  void urbiscriptPassesAsItIsWhereverItIsCut(String source) {
    for (int cut = 0; cut <= source.length(); cut++) {
      EmbeddedChannel channel = channel();
      channel.writeInbound(bytes(source.substring(0, cut)));
      channel.writeInbound(bytes(source.substring(cut)));
      assertEquals(source, received(channel), "cut at " + cut);
      assertTrue(channel.isOpen());
      channel.finishAndReleaseAll();
    }
  }

  @Test
  void undecidedBytesArePassedOnAtTheEndOfTheStream() {
    EmbeddedChannel channel = channel();
    channel.writeInbound(bytes("POST /"));
    assertEquals("", received(channel));
    channel.pipeline().fireUserEventTriggered(ChannelInputShutdownEvent.INSTANCE);
    assertEquals("POST /", received(channel));
    channel.finishAndReleaseAll();
  }

  /** Whoever sends one byte after the other must not have all of them looked at each time. */
  @Test
  void longRequestLineIsLookedAtOnce() {
    var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    EmbeddedChannel channel = channel();
    channel.writeInbound(bytes("GET /"));
    long before = threads.getCurrentThreadAllocatedBytes();
    for (int i = 0; i < 60_000; i++) {
      channel.writeInbound(bytes("x"));
    }
    long perByte = (threads.getCurrentThreadAllocatedBytes() - before) / 60_000;
    assertTrue(perByte < 5_000, perByte + " bytes allocated for each");
    assertTrue(channel.isOpen());
    channel.writeInbound(bytes(" HTTP/"));
    assertFalse(channel.isOpen());
    assertEquals("", received(channel));
    channel.finishAndReleaseAll();
  }

  @Test
  void requestIsRecognizedWhereverItIsCutInSingleBytes() {
    for (String request : new String[] {"OPTIONS /abcdefgh HTTP/", "GET /a HTTP/"}) {
      EmbeddedChannel channel = channel();
      for (char each : request.toCharArray()) {
        assertTrue(channel.isOpen(), request);
        channel.writeInbound(bytes(String.valueOf(each)));
      }
      assertFalse(channel.isOpen(), request);
      channel.finishAndReleaseAll();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"GET /abcdefgh\r\n", "GET /abcdefgh\n1;", "POST (abcdefgh) + 1;", "PUT /abc  x"})
  void whatIsNoRequestAfterAllPassesInSingleBytes(String source) {
    EmbeddedChannel channel = channel();
    for (char each : source.toCharArray()) {
      channel.writeInbound(bytes(String.valueOf(each)));
    }
    assertEquals(source, received(channel));
    channel.finishAndReleaseAll();
  }

  @Test
  void endlessRequestLineIsNotKept() {
    EmbeddedChannel channel = channel();
    channel.writeInbound(bytes("GET /"));
    for (int i = 0; i < 64 && channel.isOpen(); i++) {
      channel.writeInbound(bytes("x".repeat(1024)));
    }
    assertFalse(channel.isOpen());
    assertEquals("", received(channel));
    channel.finishAndReleaseAll();
  }
}
