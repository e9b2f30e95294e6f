package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.embedded.EmbeddedChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a client sends comes out the same wherever the network cuts it. */
class TelnetDecoderTest {
  private static final String IAC = "\u00ff";
  private static final String DO = IAC + "\u00fd";
  private static final String DONT = IAC + "\u00fe";
  private static final String WILL = IAC + "\u00fb";
  private static final String WONT = IAC + "\u00fc";
  private static final String SB = IAC + "\u00fa";
  private static final String SE = IAC + "\u00f0";
  private static final String INTERRUPT = IAC + "\u00f4";
  private static final String AYT = IAC + "\u00f6";

  /** What came out: text, replies, and a word for each interrupt. */
  private record Outcome(String text, String reply, List<Object> events) {}

  private static Outcome feed(List<String> pieces) {
    List<Object> events = new ArrayList<>();
    StringBuilder reply = new StringBuilder();
    EmbeddedChannel channel =
        new EmbeddedChannel(
            new TelnetDecoder(reply::append),
            new ChannelInboundHandlerAdapter() {
              @Override
              public void userEventTriggered(ChannelHandlerContext context, Object event) {
                events.add(event);
              }
            });
    StringBuilder text = new StringBuilder();
    for (String piece : pieces) {
      channel.writeInbound(Unpooled.copiedBuffer(piece, StandardCharsets.ISO_8859_1));
      drain(channel.inboundMessages(), text);
    }
    channel.finishAndReleaseAll();
    return new Outcome(text.toString(), reply.toString(), events);
  }

  private static void drain(Queue<Object> messages, StringBuilder text) {
    for (Object message = messages.poll(); message != null; message = messages.poll()) {
      ByteBuf bytes = (ByteBuf) message;
      text.append(bytes.toString(StandardCharsets.ISO_8859_1));
      bytes.release();
    }
  }

  /** Whole, byte by byte, and cut in two at every point: all must agree. */
  private static Outcome feedCutAtEveryPosition(String input) {
    Outcome whole = feed(List.of(input));
    assertEquals(whole, feed(input.chars().mapToObj(c -> String.valueOf((char) c)).toList()));
    for (int cut = 1; cut < input.length(); ++cut) {
      assertEquals(
          whole, feed(List.of(input.substring(0, cut), input.substring(cut))), "cut at " + cut);
    }
    return whole;
  }

  @Test
  void textGoesThrough() {
    String text = "echo(\"\u00c3\u00a9\");\n// BINARY, not a literal\nBIN;\nBIN x;\n";
    assertEquals(new Outcome(text, "", List.of()), feedCutAtEveryPosition(text));
  }

  @Test
  void theLineEndsOfTelnetLoseTheirZero() {
    assertEquals("1;\r2;\r\n3;\r", feedCutAtEveryPosition("1;\r\0" + "2;\r\n3;\r\0").text());
  }

  @Test
  void optionsAreRefused() {
    assertEquals(
        new Outcome("1;2;", WONT + "\u0001" + DONT + "\u0003", List.of()),
        feedCutAtEveryPosition(
            "1" + DO + "\u0001" + ";" + WILL + "\u0003" + WONT + "x" + DONT + "y2;"));
  }

  @Test
  void subnegotiationsAreSkipped() {
    assertEquals(
        new Outcome("12", "", List.of()),
        feedCutAtEveryPosition(
            "1" + SB + "\u0018 anything, even " + IAC + IAC + " here" + SE + "2"));
  }

  @Test
  void theInterruptKeyIsAnEvent() {
    assertEquals(
        new Outcome("12", "", List.of(TelnetInterrupt.INSTANCE)),
        feedCutAtEveryPosition("1" + INTERRUPT + "2"));
  }

  @Test
  void areYouThereIsAnswered() {
    assertEquals(
        new Outcome("12", "[yes]\r\n", List.of()), feedCutAtEveryPosition("1" + AYT + "2"));
  }

  @Test
  void aDoubledEscapeIsOneByte() {
    assertEquals("a" + IAC + "b", feedCutAtEveryPosition("a" + IAC + IAC + "b").text());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "BIN 4;%s;after\n",
        "x = BIN 4 jpeg 2 2;%s;after\n",
        "BIN 4\n%s;after\n",
        "BIN\t4 rgb 1 1;%s;BIN 4;%s;after\n"
      })
  void binaryPayloadsGoThrough(String form) {
    String text = form.replace("%s", IAC + "\u00f4\r\0");
    assertEquals(new Outcome(text, "", List.of()), feedCutAtEveryPosition(text));
  }

  @ParameterizedTest
  @CsvSource({"BIN 2;ab,BIN 2;ab", "BIN 0;,BIN 0;", "XBIN 3;,XBIN 3;", "BIN ;,BIN ;"})
  void commandsAreRecognisedAfterThePayload(String before, String text) {
    assertEquals(
        new Outcome(text + ".", "", List.of(TelnetInterrupt.INSTANCE)),
        feedCutAtEveryPosition(before + INTERRUPT + "."));
  }
}
