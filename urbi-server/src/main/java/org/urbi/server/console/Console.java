package org.urbi.server.console;

import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.lobby.ErrorStyle;

/**
 * The client of the program's own lobby, which executes {@code -e}, {@code -f} and the standard
 * input.
 */
public final class Console implements Client {
  private static final int PENDING_INPUT = 1 << 20;

  private final Consumer<String> consoleOutput;
  private final ErrorStyle errors;
  private final Runnable whenClosed;
  private volatile @Nullable Thread sender;
  private volatile boolean open = true;
  private volatile boolean failed;

  /**
   * @param consoleOutput takes the lobby's output, a byte in each character
   * @param errors how it tells of errors
   * @param whenClosed called once when the lobby is over
   */
  public Console(Consumer<String> consoleOutput, ErrorStyle errors, Runnable whenClosed) {
    this.consoleOutput = consoleOutput;
    this.errors = errors;
    this.whenClosed = whenClosed;
  }

  @Override
  public boolean isProgram() {
    return true;
  }

  @Override
  public ErrorStyle errors() {
    return errors;
  }

  @Override
  public void failed() {
    failed = true;
  }

  /** Whether the input had a syntax error or threw an exception that nobody caught. */
  public boolean hasFailed() {
    return failed;
  }

  /** Whether the lobby still takes input. */
  public boolean isOpen() {
    return open;
  }

  /** Waits until the kernel has taken most of what was sent, or the lobby is over. */
  public void awaitInputConsumed(Connection connection) {
    sender = Thread.currentThread();
    while (open && connection.pendingInput() > PENDING_INPUT) {
      LockSupport.park(this);
    }
    sender = null;
  }

  @Override
  public void output(String bytes) {
    consoleOutput.accept(bytes);
  }

  @Override
  public void inputConsumed() {
    LockSupport.unpark(sender);
  }

  @Override
  public void closed() {
    open = false;
    inputConsumed();
    whenClosed.run();
  }
}
