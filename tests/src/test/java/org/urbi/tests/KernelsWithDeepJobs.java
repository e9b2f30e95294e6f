package org.urbi.tests;

import java.util.List;
import java.util.function.Consumer;
import org.urbi.kernel.Client;
import org.urbi.kernel.Kernel;

/** The program of {@link EmbeddedMemoryTest} whose jobs keep their threads. */
final class KernelsWithDeepJobs {
  /** What the four do that the kernel can have at a time, each of another lobby. */
  private static final List<String> WAITS =
      List.of(
          "sleep(1000s)",
          "loop {}",
          "Global.t: sleep(1000s)",
          "try { waituntil (false) } finally { loop sleep(1ms) }");

  private static final Client SILENT =
      new Client() {
        @Override
        public void output(String bytes) {}

        @Override
        public void closed() {}
      };

  private KernelsWithDeepJobs() {}

  public static void main(String... arguments) throws InterruptedException {
    end("closed", Kernel::close);
    end(
        "shut down",
        kernel -> {
          kernel.requestShutdown(0);
          kernel.awaitTermination();
        });
  }

  private static void end(String how, Consumer<Kernel> end) throws InterruptedException {
    try (Kernel kernel = Kernel.builder().output(text -> {}).start()) {
      kernel.eval(
          "function Global.deep(n, code) { if (n == 0) code() else { var rest = deep(n - 1, code)| rest } };"
              + "var Global.there = 0; var Global.t = Tag.new;");
      for (String wait : WAITS) {
        kernel
            .connect(SILENT)
            .send(
                "deep(20000, closure() { Global.there++| try { "
                    + wait
                    + " } finally { sleep(1ms)| Global.there-- } });\n");
      }
      // Each has given its turn back when a millisecond has passed.
      kernel.eval("waituntil (Global.there == 4); t.freeze; sleep(1ms);");
      Object there = kernel.eval("Global.there");
      List<Thread> threads = threads();
      System.out.print("with " + threads.size() + " threads " + how + ": " + there);
      end.accept(kernel);
      for (Thread thread : threads) {
        thread.join();
      }
    }
    System.out.println(" at the bottom, none left");
  }

  private static List<Thread> threads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().equals("urbi-kernel"))
        .toList();
  }
}
