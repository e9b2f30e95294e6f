package org.urbi.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.handler.codec.PrematureChannelClosureException;
import io.netty.handler.codec.TooLongFrameException;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Who is told when something is thrown at a connection. */
class StreamFailureTest {
  private final Logger logger = Logger.getLogger("urbi.web");
  private final List<LogRecord> logged = new ArrayList<>();
  private final Handler listener =
      new Handler() {
        @Override
        public void publish(LogRecord entry) {
          logged.add(entry);
        }

        @Override
        public void flush() {}

        @Override
        public void close() {}
      };

  @BeforeEach
  void listen() {
    logger.setUseParentHandlers(false);
    logger.addHandler(listener);
  }

  @AfterEach
  void stopListening() {
    logger.removeHandler(listener);
    logger.setUseParentHandlers(true);
  }

  private static EmbeddedChannel failed(Throwable cause) {
    EmbeddedChannel channel =
        new EmbeddedChannel(
            new ChannelInboundHandlerAdapter() {
              @Override
              public void exceptionCaught(ChannelHandlerContext context, Throwable thrown) {
                StreamFailure.close(context, thrown, "a page of the test");
              }
            });
    channel.pipeline().fireExceptionCaught(cause);
    return channel;
  }

  @Test
  void brokenConnectionsAndMalformedMessagesAreNothingToTell() {
    for (Throwable cause :
        List.of(
            new IOException("reset"),
            new PrematureChannelClosureException("half a message"),
            new TooLongFrameException("of a megabyte"))) {
      EmbeddedChannel channel = failed(cause);
      assertFalse(channel.isOpen());
      assertNull(channel.readOutbound());
    }
    assertEquals(List.of(), logged);
  }

  @Test
  void whoeverSendsTooMuchIsToldHowMuchItMayBe() {
    EmbeddedChannel channel = failed(new TooLongMessage(1000));
    CloseWebSocketFrame last = channel.readOutbound();
    assertEquals(1009, last.statusCode());
    assertEquals("a message may have 1000 bytes, not more", last.reasonText());
    last.release();
    assertEquals(List.of(), logged);
    channel.finishAndReleaseAll();
  }

  @Test
  void defectIsLoggedWithItsStackAndToldToTheOtherEnd() {
    for (Throwable cause :
        List.of(new IllegalStateException("of ours"), new NoClassDefFoundError("of ours"))) {
      logged.clear();
      EmbeddedChannel channel = failed(cause);
      CloseWebSocketFrame last = channel.readOutbound();
      assertEquals(1011, last.statusCode());
      assertEquals("internal error", last.reasonText());
      last.release();
      assertFalse(channel.isOpen());
      assertEquals(1, logged.size());
      assertEquals("internal error in a page of the test", logged.get(0).getMessage());
      assertTrue(cause == logged.get(0).getThrown());
    }
  }
}
