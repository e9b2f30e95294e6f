package org.urbi.web;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.handler.codec.http.DefaultFullHttpRequest;
import io.netty.handler.codec.http.FullHttpResponse;
import io.netty.handler.codec.http.HttpMethod;
import io.netty.handler.codec.http.HttpVersion;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;

/** What a browser is sent of the files of a page, the first time and again. */
class PageFilesTest {
  private static final Page PAGE =
      new Page(PageFilesTest.class, 1000, 10, new WriteBufferWaterMark(100, 1000));

  private final PageShelf shelf = new PageShelf();

  /** What is answered: its status, its headers that are asked for, and the bytes. */
  private record Answer(int status, String encoding, String version, byte[] content) {}

  private Answer ask(boolean local, HttpMethod method, String file, String... headers) {
    EmbeddedChannel channel = new EmbeddedChannel();
    PageFiles files =
        new PageFiles(
            PAGE,
            shelf,
            new HostNames(local, "localhost", true),
            false,
            new Downloads(channel.eventLoop(), new Places()),
            ChannelInboundHandlerAdapter::new,
            null,
            null);
    channel.pipeline().addLast(files);
    DefaultFullHttpRequest request =
        new DefaultFullHttpRequest(HttpVersion.HTTP_1_1, method, "/" + file);
    request.headers().set("host", "localhost");
    for (int i = 0; i < headers.length; i += 2) {
      request.headers().set(headers[i], headers[i + 1]);
    }
    channel.writeInbound(request);
    FullHttpResponse response = channel.readOutbound();
    byte[] content = new byte[response.content().readableBytes()];
    response.content().readBytes(content).release();
    Answer answer =
        new Answer(
            response.status().code(),
            response.headers().get("content-encoding"),
            response.headers().get("etag"),
            content);
    channel.finishAndReleaseAll();
    return answer;
  }

  private static byte[] original(String file) throws IOException {
    try (InputStream content = PageFilesTest.class.getResourceAsStream(file)) {
      return content.readAllBytes();
    }
  }

  @Test
  void whatBrowserHasIsNotSentAgain() throws Exception {
    Answer first = ask(true, HttpMethod.GET, "long.css");
    assertArrayEquals(original("long.css"), first.content);
    Answer second = ask(true, HttpMethod.GET, "long.css", "if-none-match", first.version);
    assertEquals(304, second.status);
    assertEquals(0, second.content.length);
    Answer other = ask(true, HttpMethod.GET, "short.css", "if-none-match", first.version);
    assertEquals(200, other.status);
    assertArrayEquals(original("short.css"), other.content);
    assertEquals(404, ask(true, HttpMethod.GET, "none.css", "if-none-match", "*").status);
  }

  /** The pages are of different components, and the stream is one. */
  @Test
  void eachPageHasWhatAllShare() {
    Answer shared = ask(true, HttpMethod.GET, "shared/stream.js");
    assertEquals(200, shared.status);
    assertTrue(new String(shared.content, StandardCharsets.UTF_8).contains("class Stream"));
    assertEquals(404, ask(true, HttpMethod.GET, "shared/none.js").status);
    assertEquals(404, ask(true, HttpMethod.GET, "x/shared/stream.js").status);
  }

  /** Its own page may lead that name here, and then command. */
  @Test
  void nameOfAnotherSiteIsRefused() {
    Answer refused = ask(false, HttpMethod.GET, "short.css", "host", "rebound.example");
    assertEquals(403, refused.status);
    String told = new String(refused.content, StandardCharsets.US_ASCII);
    assertEquals(
        "403 Forbidden: this page is not known by that name, use the address", told.strip());
  }

  @Test
  void longFilesArePackedForOtherMachines() throws Exception {
    String[] unpacks = {"accept-encoding", "deflate, gzip"};
    Answer packed = ask(false, HttpMethod.GET, "long.css", unpacks);
    assertEquals("gzip", packed.encoding);
    assertTrue(packed.content.length < original("long.css").length / 4);
    try (InputStream content = new GZIPInputStream(new ByteArrayInputStream(packed.content))) {
      assertArrayEquals(original("long.css"), content.readAllBytes());
    }
    Answer head = ask(false, HttpMethod.HEAD, "long.css", unpacks);
    assertEquals("gzip", head.encoding);
    assertEquals(0, head.content.length);
    Answer plain = ask(false, HttpMethod.GET, "long.css");
    assertNull(plain.encoding, "who cannot unpack it");
    assertArrayEquals(original("long.css"), plain.content);
    assertNotEquals(plain.version, packed.version);
    assertNull(ask(false, HttpMethod.GET, "short.css", unpacks).encoding, "it is short");
    assertNull(ask(true, HttpMethod.GET, "long.css", unpacks).encoding, "on the same machine");
  }
}
