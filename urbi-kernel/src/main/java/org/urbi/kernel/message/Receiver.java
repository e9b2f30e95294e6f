package org.urbi.kernel.message;

/** The receiver of a message. */
@FunctionalInterface
public interface Receiver {
  /** Takes a message; on the kernel thread, between the jobs. It must not wait. */
  void take(Message message);
}
