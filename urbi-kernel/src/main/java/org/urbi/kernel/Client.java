package org.urbi.kernel;

import org.urbi.kernel.lobby.ErrorStyle;
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
   * Whether this client is the main program. When its input ends, its lobby stays open, and the
   * kernel ends once nothing can wake it. Asked when it connects.
   */
  default boolean isProgram() {
    return false;
  }

  /**
   * Whether it may still send input on its own initiative, so that the kernel must keep running for
   * it. Asked when it connects.
   */
  default boolean isAwaited() {
    return true;
  }

  /** Its connection does nothing any more: who keeps it keeps the memory of its lobby. */
  default void forgotten() {}

  /** From now on its input is raw bytes: telnet commands are no longer looked for. */
  default void binary() {}

  /** The client was sent a syntax error of its input, or an uncaught exception. */
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
   * for no limits. Asked when it connects.
   */
  default String budget() {
    return "";
  }

  /** How it is told of errors. Asked when it connects. */
  default ErrorStyle errors() {
    return ErrorStyle.PLAIN;
  }

  /** The role that its lobby starts with. Asked when it connects. */
  default Role role() {
    return Role.OWNER;
  }
}
