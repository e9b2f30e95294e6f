package org.urbi.bridge;

import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import org.jspecify.annotations.Nullable;
import urbi.UModuleException;
import urbi.remote.RemoteProgram;
import urbi.thread.GuardedThreads;

/**
 * A program of C++ with UObjects of its own, which has started this Java virtual machine in its
 * process ({@code urbi/umain.hh}) and is connected to a server.
 */
public final class NativeProgram {
  private NativeProgram() {}

  /**
   * Runs the UObjects of the program in whose process this is.
   *
   * @param words the name of the program, and options as those of {@link urbi.UMain}
   * @param block whether to return when the connection has ended; otherwise, when the UObjects run
   * @return the exit status
   */
  public static int run(String[] words, boolean block) {
    if (!block) {
      return start(words, false);
    }
    NativeModule program = open(words);
    return program == null ? 1 : run(words, program, () -> {});
  }

  /**
   * Has the UObjects of the program in whose process this is run, and returns when they do,
   * connected to the server.
   *
   * @param words the name of the program, and options as those of {@link urbi.UMain}
   * @param ends whether the program ends when the connection has ended
   * @return 0, or an exit status if they do not run
   */
  public static int start(String[] words, boolean ends) {
    NativeModule program = open(words);
    if (program == null) {
      return 1;
    }
    CompletableFuture<Integer> begun = new CompletableFuture<>();
    Runnable task =
        () -> {
          int status = run(words, program, () -> begun.complete(0));
          ended(status, begun, ends);
        };
    GuardedThreads.SDK.platform("urbi-main", task, defect -> ended(1, begun, ends)).start();
    return begun.join();
  }

  private static void ended(int status, CompletableFuture<Integer> begun, boolean ends) {
    begun.complete(status);
    if (ends) {
      System.exit(status);
    }
  }

  private static @Nullable NativeModule open(String[] words) {
    try {
      return NativeModule.ofProcess(words[0]);
    } catch (UModuleException e) {
      System.err.println(e.getMessage());
      return null;
    }
  }

  private static int run(String[] words, NativeModule program, Runnable onRunning) {
    String[] options = Arrays.copyOfRange(words, 1, words.length);
    return new RemoteProgram(onRunning).run(options, program.module(), System.out, System.err);
  }
}
