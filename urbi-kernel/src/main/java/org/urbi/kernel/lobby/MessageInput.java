package org.urbi.kernel.lobby;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Frame;

/**
 * The input of a client that no longer sends statements, but messages, some of which are
 * statements. On the kernel thread.
 */
public interface MessageInput {
  /** A step that a message requests. */
  sealed interface Step {}

  /**
   * Text to be executed, or a part of it.
   *
   * @param goesOn whether more of the last statement is to come
   */
  record Text(String code, boolean goesOn) implements Step {}

  /** Something else. */
  @FunctionalInterface
  non-sealed interface Command extends Step {
    void perform(Frame frame);
  }

  /** Takes bytes, as they come. */
  void receive(String bytes);

  /** The next step; null while there is none. */
  @Nullable Step next();

  /** Whether there are answers among the steps. */
  boolean hasAnswers();

  /** Handles the answers before other steps: the running code may wait for one. */
  void answer();

  /** The number of bytes of the waiting steps. */
  int pending();
}
