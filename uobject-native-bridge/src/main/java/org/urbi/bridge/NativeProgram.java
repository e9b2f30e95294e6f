package org.urbi.bridge;

import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;
import urbi.UModuleException;
import urbi.remote.RemoteProgram;
import urbi.thread.GuardedThreads;
import urbi.thread.InternalFailure;

/**
 * A program of C++ with UObjects of its own, which has started this Java virtual machine in its
 * process ({@code urbi/umain.hh}) and is connected to a server.
 */
public final class NativeProgram {
  private static final String THREAD = "urbi-main";

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
    return start(onRunning -> run(words, program, onRunning), ends, Thread::start);
  }

  /**
   * Starts it on a thread of its own. Native code calls, so nothing is thrown.
   *
   * @param program runs it, tells when it is connected, and returns its exit status
   * @param begin starts the thread, or throws if there is none
   */
  static int start(ToIntFunction<Runnable> program, boolean ends, Consumer<Thread> begin) {
    CompletableFuture<Integer> begun = new CompletableFuture<>();
    Runnable task =
        () -> {
          int status = program.applyAsInt(() -> begun.complete(0));
          ended(status, begun, ends);
        };
    try {
      begin.accept(GuardedThreads.SDK.platform(THREAD, task, defect -> ended(1, begun, ends)));
    } catch (OutOfMemoryError e) {
      InternalFailure.log("the thread " + THREAD, e);
      return 1;
    }
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
