package org.urbi.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.ArrayDeque;
import java.util.concurrent.Executor;

/**
 * The cost of virtual threads alone: the programs {@code switch} and {@code spawn} on an executor
 * that is a loop like the kernel's. It uses the same protocol as the drivers of the other
 * languages.
 */
public final class PlainVirtualThreads {
  private static final int SWITCHING = 100;
  private static final int SWITCHES = 1_000;
  private static final int SPAWNED = 10_000;
  private static final MethodHandle NEW_BUILDER = findBuilder();

  private final ArrayDeque<Runnable> runnable = new ArrayDeque<>();
  private final Executor executor = runnable::add;
  private int done;

  private PlainVirtualThreads() {}

  /** Runs the named program as often as the standard input says. */
  public static void main(String[] args) throws Throwable {
    PlainVirtualThreads bare = new PlainVirtualThreads();
    Throwable[] failure = new Throwable[1];
    // The same stack as the kernel's thread has.
    Thread loop =
        new Thread(
            null,
            () -> {
              try {
                bare.serve(args[0]);
              } catch (IOException e) {
                failure[0] = e;
              }
            },
            "loop",
            512L << 20);
    loop.start();
    loop.join();
    if (failure[0] != null) {
      throw failure[0];
    }
  }

  private void serve(String program) throws IOException {
    System.out.println("ready");
    BufferedReader input = new BufferedReader(new InputStreamReader(System.in));
    for (String line = input.readLine(); line != null; line = input.readLine()) {
      String[] words = line.split(" ");
      int result = 0;
      for (int times = Integer.parseInt(words[1]); times > 0; times--) {
        result = turn(program, words[0].equals("base"));
      }
      System.out.printf("%.6f%n", (double) result);
    }
  }

  private int turn(String program, boolean base) {
    done = 0;
    int threads = program.equals("spawn") ? SPAWNED : SWITCHING;
    Runnable body = program.equals("spawn") ? () -> done++ : this::switchOften;
    if (base) {
      for (int i = 0; i < threads; i++) {
        for (int j = 0; j < SWITCHES; j++) {
          done++;
        }
      }
      return done;
    }
    for (int i = 0; i < threads; i++) {
      start(body);
    }
    Runnable next;
    while ((next = runnable.poll()) != null) {
      next.run();
    }
    return done;
  }

  private void switchOften() {
    for (int i = 0; i < SWITCHES; i++) {
      Thread.yield();
    }
    done += SWITCHES;
  }

  private void start(Runnable body) {
    try {
      ((Thread.Builder.OfVirtual) NEW_BUILDER.invokeExact(executor)).start(body);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }

  private static MethodHandle findBuilder() {
    try {
      Class<?> builder = Class.forName("java.lang.ThreadBuilders$VirtualThreadBuilder");
      var constructor = builder.getDeclaredConstructor(Executor.class);
      constructor.setAccessible(true);
      return MethodHandles.lookup()
          .unreflectConstructor(constructor)
          .asType(MethodType.methodType(Thread.Builder.OfVirtual.class, Executor.class));
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("run with --add-opens java.base/java.lang=ALL-UNNAMED", e);
    }
  }
}
