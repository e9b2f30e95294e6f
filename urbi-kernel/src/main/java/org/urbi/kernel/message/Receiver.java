package org.urbi.kernel.message;

/** Whom a message is for. */
@FunctionalInterface
public interface Receiver {
  /** Takes a message; on the kernel thread, between the jobs. It must not wait. */
  void take(Message message);
}
