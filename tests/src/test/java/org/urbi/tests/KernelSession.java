package org.urbi.tests;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.KernelBuilder;
import org.urbi.kernel.job.JobThreads;

/**
 * A kernel and the consoles that tests open on it. This is the only class of the tests that knows
 * the kernel's Java interface.
 */
public final class KernelSession implements AutoCloseable {

  /** The two ways to run jobs; both have to give the same output. */
  enum BackEnd {
    TICK_LOOP(JobThreads.TICK_LOOP),
    BATON(JobThreads.BATON);

    private final JobThreads jobThreads;

    BackEnd(JobThreads jobThreads) {
      this.jobThreads = jobThreads;
    }
  }

  /** How a program reaches the kernel; it must not matter. */
  enum InputMode {
    WHOLE,
    BYTE_BY_BYTE
  }

  /**
   * What ends a program: a moment for what its last statement has set off to say its last word, and
   * the end of the kernel.
   */
  private static final String EPILOGUE = "\nsleep(1ms)|;\nshutdown;\n";

  /** A statement whose result tells that the kernel thread is ours for the time of a callback. */
  private static final String STARTER = "0;";

  private static final Executor DAEMONS = task -> Thread.ofPlatform().daemon().start(task);

  private final Kernel kernel;

  /** The library's own source files, which installations have in their search path. */
  private static final Path LIBRARY = Path.of("../share").toAbsolutePath();

  private KernelSession(Kernel kernel) {
    this.kernel = kernel;
  }

  private static KernelBuilder builder(BackEnd backEnd) {
    return Kernel.builder()
        .jobThreads(backEnd.jobThreads)
        .searchPath(List.of(LIBRARY))
        .library(LIBRARY)
        .log(KernelSession::checkLog)
        .moduleSearchPath(List.of(UObjectJars.folder()));
  }

  /** The log is not looked at, but for a defect that nothing else would show. */
  private static void checkLog(String line) {
    if (line.startsWith("urbi: code is not compiled")) {
      throw new AssertionError(line);
    }
  }

  /** A kernel whose time jumps from deadline to deadline. */
  static KernelSession inVirtualTime(BackEnd backEnd) {
    return new KernelSession(builder(backEnd).virtualTime(true).start());
  }

  /** A kernel that lives in our time. */
  static KernelSession inRealTime(BackEnd backEnd) {
    return new KernelSession(builder(backEnd).virtualTime(false).start());
  }

  /**
   * Runs a program on a fresh kernel in virtual time until it, or what is put at its end, shuts the
   * kernel down or quits the connection.
   *
   * @return everything that the kernel has sent
   */
  static String run(BackEnd backEnd, InputMode feeding, String program) {
    return run(builder(backEnd), feeding, program);
  }

  /**
   * Runs likewise what a reader of the documentation types.
   *
   * @param modules where its modules and files are
   * @param root of the project, the folder in which the reader works
   */
  public static String runAsReader(Path modules, Path root, String program) {
    KernelBuilder builder =
        builder(BackEnd.TICK_LOOP)
            .searchPath(List.of(LIBRARY, root.toAbsolutePath(), modules))
            .moduleSearchPath(List.of(modules))
            .seed(1);
    return run(builder, InputMode.WHOLE, program);
  }

  /**
   * Runs a program likewise, and compiles what is hot.
   *
   * @param threshold after how many calls or turns; 0 for never
   * @param doubt every how many times compiled code takes the slow path in spite of itself, or 0
   * @param stack the size of it that limits nested calls, in KiB; 0 for as much as there is
   */
  static String runCompiled(int threshold, int doubt, int stack, String program) {
    return run(
        builder(BackEnd.TICK_LOOP).tier(threshold).tierDoubt(doubt).stackSize(stack),
        InputMode.WHOLE,
        program);
  }

  /** Runs a program likewise in our time; what is sent has no time stamps. */
  static String runCompiledInRealTime(int threshold, String program) {
    KernelBuilder builder = builder(BackEnd.TICK_LOOP).tier(threshold).virtualTime(false);
    return runUntilEnd(builder, InputMode.WHOLE, program).replaceAll("(?m)^\\[\\d+", "[");
  }

  private static String run(KernelBuilder builder, InputMode feeding, String program) {
    return runUntilEnd(builder.virtualTime(true), feeding, program);
  }

  private static String runUntilEnd(KernelBuilder builder, InputMode feeding, String program) {
    String input = program + EPILOGUE;
    try (KernelSession session = new KernelSession(builder.start())) {
      Console console = session.connect();
      if (feeding == InputMode.WHOLE) {
        console.send(input);
      } else {
        session.sendByteByByte(console, input);
      }
      session.awaitEnd(console);
      return console.output();
    }
  }

  /** Opens a connection. */
  Console connect() {
    Console console = new Console();
    console.connection = kernel.connect(console);
    return console;
  }

  /**
   * Sends a text in as many pieces as it has bytes. In virtual time the clock would run away
   * between two of them: so they are sent from the kernel thread itself, when it delivers the first
   * result of another connection, and are all there when it goes on.
   */
  private void sendByteByByte(Console console, String bytes) {
    Connection[] other = new Connection[1];
    other[0] =
        kernel.connect(
            new Client() {
              @Override
              public void output(String result) {
                // The connection is known: it has been sent the statement of which this comes.
                for (char c : bytes.toCharArray()) {
                  console.send(String.valueOf(c));
                }
                other[0].close();
              }

              @Override
              public void closed() {}
            });
    other[0].send(STARTER);
  }

  /** Waits until the kernel has shut down; returns its status. */
  int awaitShutdown() {
    try {
      return kernel.awaitTermination();
    } catch (Exception e) {
      throw new IllegalStateException("the kernel did not end well", e);
    }
  }

  private void awaitEnd(Console console) {
    try {
      CompletableFuture.anyOf(
              console.closed, CompletableFuture.supplyAsync(this::awaitShutdown, DAEMONS))
          .get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
    } catch (ExecutionException | InterruptedException | TimeoutException e) {
      throw new AssertionError("the program has not ended; so far:\n" + console.output(), e);
    }
  }

  @Override
  public void close() {
    kernel.close();
  }

  /** The user's end of a connection; every character is one byte. */
  static final class Console implements Client {
    private final CompletableFuture<Void> closed = new CompletableFuture<>();
    private final ConcurrentLinkedQueue<Expectation> expectations = new ConcurrentLinkedQueue<>();
    private final StringBuilder output = new StringBuilder();
    private volatile Connection connection;

    private record Expectation(String text, CompletableFuture<Void> met) {}

    void send(String bytes) {
      connection.send(bytes);
    }

    /** No more input. */
    void end() {
      connection.end();
    }

    /** Completes when the kernel has closed the connection. */
    CompletableFuture<Void> whenClosed() {
      return closed;
    }

    /** Completes when a text has been received. */
    CompletableFuture<Void> receives(String text) {
      Expectation expectation = new Expectation(text, new CompletableFuture<>());
      expectations.add(expectation);
      check();
      return expectation.met();
    }

    /** What was received so far. */
    String output() {
      synchronized (output) {
        return output.toString();
      }
    }

    @Override
    public void output(String bytes) {
      synchronized (output) {
        output.append(bytes);
      }
      check();
    }

    @Override
    public void closed() {
      closed.complete(null);
    }

    private void check() {
      if (expectations.isEmpty()) {
        return;
      }
      String received = output();
      List<Expectation> met = new ArrayList<>();
      for (Expectation expectation : expectations) {
        if (received.contains(expectation.text())) {
          met.add(expectation);
        }
      }
      expectations.removeAll(met);
      met.forEach(expectation -> expectation.met().complete(null));
    }
  }
}
