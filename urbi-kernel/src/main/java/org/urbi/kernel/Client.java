package org.urbi.kernel;

/** Who is at the other end of a {@link Connection}. Called on the kernel thread; must not block. */
public interface Client {
  /** Output, whole lines: every {@code char} is one byte. */
  void output(String bytes);

  /** The kernel has closed the connection: {@code quit}, shutdown, or the end of its input. */
  void closed();

  /** Some of the input that was sent has been taken: {@link Connection#pendingInput} went down. */
  default void inputConsumed() {}

  /** The Internet address at the other end; empty when there is none. */
  default String remoteAddress() {
    return "";
  }
}
