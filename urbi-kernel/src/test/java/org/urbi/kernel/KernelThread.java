package org.urbi.kernel;

import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.message.Message;

/** Has things done on the thread of a kernel, between the jobs. */
final class KernelThread {
  private KernelThread() {}

  static void run(Kernel kernel, Runnable task) {
    Inbox inbox = kernel.scheduler().inbox();
    int number = inbox.reserve();
    inbox.register(
        number,
        message -> {
          inbox.forget(number);
          task.run();
        });
    inbox.post(new Message.InputEnded(number));
  }
}
