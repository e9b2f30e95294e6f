package org.urbi.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.channel.EventLoopGroup;
import io.netty.channel.IoHandle;
import io.netty.channel.IoHandler;
import io.netty.channel.IoHandlerContext;
import io.netty.channel.IoRegistration;
import io.netty.channel.MultiThreadIoEventLoopGroup;
import io.netty.channel.nio.NioIoHandler;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** An {@code Error} on the thread of many connections does not end it. */
class NetworkLoopTest {
  /** Less than the limit of a test, so that it can say what it has waited for. */
  private static final int SECONDS = Integer.getInteger("test.limit", 600) / 2;

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
        assertEquals("done", loop.submit(() -> "done").get(SECONDS, TimeUnit.SECONDS));
      }
      assertEquals("the network thread: for a connection", told.getFirst());
    } finally {
      loop.shutdownGracefully(0, 1, TimeUnit.SECONDS).sync();
    }
  }

  @Test
  void tasksThatHaveTheirTimeGoOnAndAreTold() throws Exception {
    List<String> told = new CopyOnWriteArrayList<>();
    EventLoopGroup loop =
        NetworkLoop.group("of-test", (where, failure) -> told.add(where + ": " + failure));
    try {
      CountDownLatch runs = new CountDownLatch(2);
      Runnable failing =
          () -> {
            runs.countDown();
            throw new NoClassDefFoundError("lost");
          };
      loop.next().scheduleAtFixedRate(failing, 0, 1, TimeUnit.MICROSECONDS);
      loop.next().schedule(failing, 0, TimeUnit.SECONDS);
      assertTrue(runs.await(SECONDS, TimeUnit.SECONDS), told::toString);
      assertEquals("the thread of-test: java.lang.NoClassDefFoundError: lost", told.getFirst());
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
