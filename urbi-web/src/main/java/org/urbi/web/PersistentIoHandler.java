package org.urbi.web;

import io.netty.channel.IoHandle;
import io.netty.channel.IoHandler;
import io.netty.channel.IoHandlerContext;
import io.netty.channel.IoRegistration;
import java.util.function.BiConsumer;

/**
 * What a network thread waits with for its channels, and goes on with after an {@code Error}, such
 * as that there is no memory for one connection: Netty would end the thread without a word, and
 * with it all connections.
 */
final class PersistentIoHandler implements IoHandler {
  /** So many in a row are no accident: then the thread ends, and the watchdog ends the server. */
  private static final int MOST_ERRORS = 100;

  private static final String WHERE = "the network thread";

  private final IoHandler handler;
  private final BiConsumer<String, Throwable> log;
  private int errors;

  /**
   * @param handler does the work
   * @param log told where something has failed, and what it was
   */
  PersistentIoHandler(IoHandler handler, BiConsumer<String, Throwable> log) {
    this.handler = handler;
    this.log = log;
  }

  @Override
  public int run(IoHandlerContext context) {
    try {
      int handled = handler.run(context);
      errors = 0;
      return handled;
    } catch (Error e) {
      errors++;
      log.accept(WHERE, e);
      if (errors >= MOST_ERRORS) {
        throw e;
      }
      return 0;
    }
  }

  @Override
  public void initialize() {
    handler.initialize();
  }

  @Override
  public void prepareToDestroy() {
    handler.prepareToDestroy();
  }

  @Override
  public void destroy() {
    handler.destroy();
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
