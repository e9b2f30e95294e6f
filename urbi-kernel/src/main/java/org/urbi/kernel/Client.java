package org.urbi.kernel;

import org.urbi.kernel.trust.Role;

/** Who is at the other end of a {@link Connection}. Called on the kernel thread; must not block. */
public interface Client {
  /** Output, whole lines: every {@code char} is one byte. */
  void output(String bytes);

  /** The kernel has closed the connection: {@code quit}, shutdown, or the end of its input. */
  void closed();

  /** Some of the input that was sent has been taken: {@link Connection#pendingInput} went down. */
  default void inputConsumed() {}

  /**
   * Whether the run is this client's: when it has no more input, its lobby stays, and the kernel
   * ends when nothing can wake it.
   */
  default boolean isProgram() {
    return false;
  }

  /** Whether it may send something that nobody expects, so that the kernel waits for it. */
  default boolean isAwaited() {
    return true;
  }

  /** From now on each byte that it sends counts: nothing in its input is a command of telnet. */
  default void binary() {}

  /** It has been told of a syntax error in its input, or of an exception that nobody caught. */
  default void failed() {}

  /** The Internet address at the other end; empty when there is none. */
  default String remoteAddress() {
    return "";
  }

  /** How many bytes of output it has not taken yet; 0 when nobody knows. */
  default long unread() {
    return 0;
  }

  /**
   * What its lobby may have at a time, as {@code jobs=100,output=1M} (docs/robustness.md); empty
   * for as much as there is. Asked when it connects.
   */
  default String budget() {
    return "";
  }

  /** What its lobby may do in the beginning; asked when it connects. */
  default Role role() {
    return Role.OWNER;
  }
}
