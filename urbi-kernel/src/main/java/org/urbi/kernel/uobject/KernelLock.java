package org.urbi.kernel.uobject;

import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.message.Message;

/**
 * The lock of the kernel by a thread ({@link urbi.UContext#lock}): a job occupies the kernel thread
 * and does only what the owner asks for, until that unlocks it or ends. Used by the owner.
 */
final class KernelLock {
  private final Inbox inbox;
  private final int receiver;
  private final Thread watch;
  private int depth = 1;

  /** The calling thread is about to lock the kernel. */
  KernelLock(Inbox inbox) {
    this.inbox = inbox;
    this.receiver = inbox.reserve();
    Thread owner = Thread.currentThread();
    watch = FailureLog.THREADS.virtual("urbi-lock", () -> unlockAfter(owner));
    watch.start();
  }

  /** Nobody else could unlock it when its owner has ended. */
  private void unlockAfter(Thread owner) {
    try {
      owner.join();
      inbox.post(new Message.KernelUnlocked(receiver));
    } catch (InterruptedException unlocked) {
      // The owner has unlocked it.
    }
  }

  /** The receiver of what the owner asks for. */
  int receiver() {
    return receiver;
  }

  /** Asks for something. */
  void ask(Message.OfComponent what) {
    inbox.post(new Message.AskedWhileLocked(receiver, what));
  }

  /** Locks it once more. */
  void enter() {
    depth++;
  }

  /** Unlocks it once: true if that was the outermost lock. */
  boolean end() {
    depth--;
    if (depth == 0) {
      watch.interrupt();
      inbox.post(new Message.KernelUnlocked(receiver));
    }
    return depth == 0;
  }
}
