package org.urbi.kernel.uobject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.ReplayedRun;
import urbi.UObject;

/** A job that waits for what a component has promised is stopped: nobody wants the promise then. */
class StoppedWaitTest {
  @TempDir Path folder;

  /** Promises what never comes, and counts what was given up. */
  public static final class Promising extends UObject {
    private final CompletableFuture<Integer> shared = new CompletableFuture<>();
    private int givenUp;

    public Promising(String name) {
      super(name);
      UBindFunctions("later", "copied", "dependent", "stubborn", "closed", "givenUp", "isKept");
    }

    public CompletableFuture<Integer> later() {
      CompletableFuture<Integer> promise = new CompletableFuture<>();
      promise.whenComplete((value, failure) -> {
        if (promise.isCancelled()) {
          givenUp++;
        }
        throw new IllegalStateException("nobody hears of this");
      });
      return promise;
    }

    /** For those who give many the same promise. */
    public CompletionStage<Integer> copied() {
      return shared.copy();
    }

    public CompletionStage<Integer> dependent() {
      return shared.thenApply(value -> value + 1);
    }

    /** Does not want to be cancelled. */
    public CompletionStage<Integer> stubborn() {
      return new CompletableFuture<>() {
        @Override
        public boolean cancel(boolean interrupts) {
          throw new IllegalStateException("no");
        }
      };
    }

    /** Cannot be cancelled. */
    public CompletionStage<Integer> closed() {
      return shared.minimalCompletionStage();
    }

    public int givenUp() {
      return givenUp;
    }

    public boolean isKept() {
      return !shared.isDone();
    }
  }

  private static String stopping(String function) {
    return "{ var t = Tag.new| t: { Promising.%s| echo(\"not stopped\") }, sleep(10ms)| t.stop };"
        .formatted(function);
  }

  private static Kernel start(StringBuffer shown) {
    Kernel kernel = Kernel.builder().virtualTime(true).output(shown::append).start();
    kernel.start(Promising.class);
    return kernel;
  }

  @Test
  void thePromiseIsCancelled() {
    StringBuffer shown = new StringBuffer();
    try (Kernel kernel = start(shown)) {
      kernel.eval(stopping("later"));
      assertEquals(1, kernel.eval("Promising.givenUp", int.class));
      kernel.eval("timeout (10ms) Promising.later;");
      assertEquals(2, kernel.eval("Promising.givenUp", int.class));
    }
    assertEquals("", shown.toString());
  }

  @Test
  void whoeverIsOnlyFrozenGoesOnWaiting() {
    StringBuffer shown = new StringBuffer();
    try (Kernel kernel = start(shown)) {
      kernel.eval("var Global.t = Tag.new|;");
      kernel.evalAsync("t: Promising.later;");
      kernel.eval("sleep(10ms)| t.freeze| sleep(10ms)| t.unfreeze;");
      assertEquals(0, kernel.eval("Promising.givenUp", int.class));
    }
  }

  @Test
  void whatOthersWaitForRemains() {
    StringBuffer shown = new StringBuffer();
    try (Kernel kernel = start(shown)) {
      for (String each : new String[] {"copied", "dependent", "closed"}) {
        kernel.eval(stopping(each));
        assertTrue(kernel.eval("Promising.isKept", boolean.class), each);
      }
    }
    assertEquals("", shown.toString());
  }

  @Test
  void oneThatCannotBeCancelledIsLeft() {
    StringBuffer shown = new StringBuffer();
    try (Kernel kernel = start(shown)) {
      kernel.eval(stopping("stubborn"));
      assertEquals(3, kernel.eval("1 + 2", int.class));
    }
    assertEquals("", shown.toString());
  }

  @Test
  void aReplayGivesUpTheSame() {
    Path run = folder.resolve("run");
    String shown =
        ReplayedRun.recorded(
            run,
            kernel -> {
              kernel.start(Promising.class);
              kernel.eval(stopping("later") + " sleep(10ms); echo(Promising.givenUp)");
            });
    assertTrue(shown.endsWith("*** 1\n"), shown);
    assertEquals(shown, ReplayedRun.replayed(run));
  }
}
