package org.urbi.server.console;

import java.util.function.Consumer;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;

/** The program's own lobby: where {@code -e}, {@code -f} and the standard input go. */
public final class Console implements Client {
  private static final int PENDING_INPUT = 1 << 20;

  private final Consumer<String> screen;
  private final Runnable whenClosed;
  private final Object consumed = new Object();
  private volatile boolean open = true;

  /**
   * @param screen takes the lobby's output, a byte in each character
   * @param whenClosed called once when the lobby is over
   */
  public Console(Consumer<String> screen, Runnable whenClosed) {
    this.screen = screen;
    this.whenClosed = whenClosed;
  }

  /** Whether the lobby still listens. */
  public boolean isOpen() {
    return open;
  }

  /** Waits until the kernel has taken most of what was sent, or the lobby is over. */
  public void awaitInputConsumed(Connection connection) throws InterruptedException {
    synchronized (consumed) {
      while (open && connection.pendingInput() > PENDING_INPUT) {
        consumed.wait();
      }
    }
  }

  @Override
  public void output(String bytes) {
    screen.accept(bytes);
  }

  @Override
  public void inputConsumed() {
    synchronized (consumed) {
      consumed.notifyAll();
    }
  }

  @Override
  public void closed() {
    open = false;
    inputConsumed();
    whenClosed.run();
  }
}
