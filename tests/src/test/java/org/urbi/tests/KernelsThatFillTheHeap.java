package org.urbi.tests;

import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.kernel.job.JobThreads;

/** A Java program with several kernels, of which one after the other fills the heap. */
final class KernelsThatFillTheHeap {
  private KernelsThatFillTheHeap() {}

  /**
   * @param arguments none
   */
  public static void main(String[] arguments) throws InterruptedException {
    try (Kernel good = Kernel.builder().start()) {
      fill(JobThreads.TICK_LOOP);
      fill(JobThreads.BATON);
      System.out.println("the other one: " + good.eval("sleep(1ms) | 2 + 1"));
    }
    while (Thread.getAllStackTraces().keySet().stream()
        .anyMatch(thread -> thread.getName().equals("urbi-memory"))) {
      Thread.sleep(10);
    }
    System.out.println("the watchdog has ended");
  }

  private static void fill(JobThreads jobThreads) {
    try (Kernel bad =
        Kernel.builder().jobThreads(jobThreads).output(text -> {}).log(line -> {}).start()) {
      try {
        bad.eval("{ var l = [] | while| (true) l << \"x\" * 1000 }");
      } catch (UrbiError e) {
        System.out.println(jobThreads + ": " + e.getMessage());
      }
      System.out.println(jobThreads + ": " + bad.eval("1 + 1"));
    }
  }
}
