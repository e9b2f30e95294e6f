package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import io.netty.channel.IoHandle;
import io.netty.channel.IoHandler;
import io.netty.channel.IoHandlerContext;
import io.netty.channel.IoRegistration;
import io.netty.channel.MultiThreadIoEventLoopGroup;
import io.netty.channel.nio.NioIoHandler;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.urbi.server.TestTimeout;

/** An {@code Error} between two channels does not end the network. */
class PersistentIoHandlerTest {
  /** Fails so many times. */
  private static final class Failing implements IoHandler {
    private final IoHandler handler;
    private final AtomicInteger failures;

    Failing(IoHandler handler, int failures) {
      this.handler = handler;
      this.failures = new AtomicInteger(failures);
    }

    @Override
    public int run(IoHandlerContext context) {
      if (failures.getAndDecrement() > 0) {
        throw new OutOfMemoryError("for a connection");
      }
      return handler.run(context);
    }

    @Override
    public IoRegistration register(IoHandle handle) throws Exception {
      return handler.register(handle);
    }

    @Override
    public void wakeup() {
      handler.wakeup();
    }

    @Override
    public boolean isCompatible(Class<? extends IoHandle> type) {
      return handler.isCompatible(type);
    }
  }

  @Test
  void threadGoesOnAndTellsWhy() throws Exception {
    List<String> told = new CopyOnWriteArrayList<>();
    var loop =
        new MultiThreadIoEventLoopGroup(
            1,
            executor ->
                new PersistentIoHandler(
                    new Failing(NioIoHandler.newFactory().newHandler(executor), 50),
                    (where, failure) -> told.add(where + ": " + failure.getMessage())));
    try {
      for (int i = 0; i < 100; i++) {
        assertEquals(
            "done", loop.submit(() -> "done").get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS));
      }
      assertEquals("the network thread: for a connection", told.getFirst());
    } finally {
      loop.shutdownGracefully(0, 1, TimeUnit.SECONDS).sync();
    }
  }

  @Test
  void whatFailsAlwaysEnds() {
    List<String> told = new ArrayList<>();
    var handler =
        new PersistentIoHandler(
            new Failing(new Failing(null, 0), Integer.MAX_VALUE),
            (where, failure) -> told.add(where));
    for (int i = 1; i < 100; i++) {
      assertEquals(0, handler.run(null));
    }
    assertThrows(OutOfMemoryError.class, () -> handler.run(null));
    assertEquals(100, told.size());
  }
}
