package org.urbi.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelOutboundHandlerAdapter;
import io.netty.channel.ChannelPromise;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.handler.codec.http.HttpContent;
import io.netty.handler.codec.http.HttpResponse;
import io.netty.handler.codec.http.LastHttpContent;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A file on its way to a browser that takes each piece when it likes. */
class DeliveryTest {
  private static final int MINUTE = 60;

  /** What has been written, and has not left. */
  private record Held(Object message, ChannelPromise promise) {}

  @TempDir Path folder;

  private final Queue<Held> held = new ArrayDeque<>();
  private final EmbeddedChannel channel =
      new EmbeddedChannel(
          new ChannelOutboundHandlerAdapter() {
            @Override
            public void write(ChannelHandlerContext context, Object message, ChannelPromise left) {
              held.add(new Held(message, left));
            }
          });

  @BeforeEach
  void stopTheClock() {
    channel.freezeTime();
  }

  @AfterEach
  void close() {
    channel.finishAndReleaseAll();
  }

  private Path file(long size) throws IOException {
    Path file = folder.resolve("a \"name\".mcap");
    try (RandomAccessFile made = new RandomAccessFile(file.toFile(), "rw")) {
      made.setLength(size);
    }
    return file;
  }

  private HttpResponse begin(Path file) throws IOException {
    channel.pipeline().addLast(new Delivery(file));
    Held head = held.remove();
    head.promise.setSuccess();
    return assertInstanceOf(HttpResponse.class, head.message);
  }

  /** The browser takes the next piece; how long it is. */
  private int take() {
    Held next = held.remove();
    HttpContent content = assertInstanceOf(HttpContent.class, next.message);
    int size = content.content().readableBytes();
    content.release();
    next.promise.setSuccess();
    channel.runPendingTasks();
    return size;
  }

  @Test
  void aPieceIsReadWhenTheOneBeforeHasLeft() throws Exception {
    HttpResponse head = begin(file(2L * Delivery.PIECE + 5));
    assertEquals(String.valueOf(2 * Delivery.PIECE + 5), head.headers().get("content-length"));
    assertEquals(
        "attachment; filename*=UTF-8''a%20%22name%22.mcap",
        head.headers().get("content-disposition"));
    for (int size : new int[] {Delivery.PIECE, Delivery.PIECE, 5}) {
      assertEquals(1, held.size(), "one piece at a time");
      assertEquals(size, take());
    }
    assertInstanceOf(LastHttpContent.class, held.element().message);
    assertEquals(0, take());
    assertFalse(channel.isOpen());
  }

  @Test
  void whoTakesNothingForAMinuteIsLeftAlone() throws Exception {
    begin(file(3L * Delivery.PIECE));
    for (int i = 0; i < 2; i++) {
      channel.advanceTimeBy(MINUTE - 1, TimeUnit.SECONDS);
      channel.runScheduledPendingTasks();
      assertTrue(channel.isOpen());
      take();
    }
    channel.advanceTimeBy(MINUTE, TimeUnit.SECONDS);
    channel.runScheduledPendingTasks();
    assertFalse(channel.isOpen());
  }

  /** As a recording does that is begun anew under the same name. */
  @Test
  void aFileThatBecomesShorterEndsTheConnection() throws Exception {
    Path file = file(2L * Delivery.PIECE);
    begin(file);
    Files.write(file, new byte[1]);
    take();
    assertTrue(held.isEmpty());
    assertFalse(channel.isOpen());
  }

  @Test
  void anOfferIsForOneAndForAMinute() throws Exception {
    Downloads downloads = new Downloads(channel.eventLoop(), new Places());
    Path file = file(1);
    String first = downloads.offer(file);
    assertNull(downloads.take(first.substring(0, first.length() - 1), channel));
    assertEquals(file, downloads.take(first, channel));
    assertNull(downloads.take(first, channel));
    String second = downloads.offer(file);
    channel.advanceTimeBy(MINUTE, TimeUnit.SECONDS);
    channel.runScheduledPendingTasks();
    assertNull(downloads.take(second, channel));
  }
}
