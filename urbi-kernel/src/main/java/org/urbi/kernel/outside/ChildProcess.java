package org.urbi.kernel.outside;

import static java.util.Objects.requireNonNull;

import java.io.Closeable;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.message.Message;

/** A running program: its pipes, and its end. Used on the kernel thread. */
public final class ChildProcess {
  /** Shells and the JDK add this to the number of the signal that ended a program. */
  private static final int SIGNALED = 128;

  private static final int LAST_SIGNAL = 64;

  private static final int KILLED = SIGNALED + 9;

  /** For how long the pipes of a program that has ended may be open before its end is told. */
  private static final Duration LINGERING = Duration.ofSeconds(2);

  private final Outside outside;
  private final WaitingJobs waiters = new WaitingJobs();

  /** Null in a replay. */
  private final @Nullable Process process;

  /** Whose it is. */
  private final Budget budget;

  private final PipeSink in;
  private final PipeSource out;
  private final PipeSource err;
  private @Nullable Integer status;

  /**
   * @param process null in a replay
   * @param budget from which its place was taken
   */
  ChildProcess(Outside outside, @Nullable Process process, Budget budget) {
    this.outside = outside;
    this.process = process;
    this.budget = budget;
    in = new PipeSink(outside, process == null ? null : process.getOutputStream(), false);
    out = new PipeSource(outside, process == null ? null : process.getInputStream());
    err = new PipeSource(outside, process == null ? null : process.getErrorStream());
    int number = outside.inbox().register(this::ended);
    if (process != null) {
      // While the process runs, it keeps alive the object that kills it.
      Closeable end = () -> end(process);
      outside.opened(end);
      outside.start(() -> {
        int last = awaitEnd(process);
        outside.closed(end);
        outside.inbox().post(new Message.ProcessEnded(number, last));
      });
    }
    outside.scheduler().pace().begin();
  }

  /**
   * Waits until the program has ended, and our ends of its pipes are closed: all that it wrote is
   * told before its end, and whoever counts open files then does not find those of its pipes.
   *
   * @return the status
   */
  private int awaitEnd(Process running) {
    int last = KILLED;
    try {
      last = running.waitFor();
      CompletableFuture.allOf(in.end(), out.end(), err.end())
          .get(LINGERING.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      // Another program has inherited a pipe, and holds it open, maybe for ever.
    } catch (Throwable e) {
      FailureLog.internal("waiting for a program", e);
      running.destroyForcibly();
    }
    out.abandon();
    err.abandon();
    return last;
  }

  private void ended(Message message) {
    Message.ProcessEnded end = (Message.ProcessEnded) message;
    outside.inbox().forget(end.to());
    outside.scheduler().pace().end();
    status = end.status();
    budget.giveBack(Resource.PROCESSES);
    in.readerGone();
    waiters.wake();
  }

  /**
   * Starts a program while the job waits.
   *
   * @throws IOException when there is no such program, or it cannot be run
   */
  public static ChildProcess start(
      Outside outside, Job job, List<String> command, Path directory, Map<String, String> env)
      throws IOException {
    outside.confinement().checkProcesses();
    job.identity().take(Resource.PROCESSES);
    ProgramStart start = ProgramStart.of(outside, () -> builder(command, directory, env).start());
    boolean started = false;
    try {
      Process process = outside.awaitOpen(job, start);
      ChildProcess child = new ChildProcess(outside, process, job.budget());
      started = true;
      start.over();
      return child;
    } finally {
      if (!started) {
        // The job was ended meanwhile, or nobody watches it, as the machine has no more threads.
        start.abandon();
        job.budget().giveBack(Resource.PROCESSES);
      }
    }
  }

  /**
   * Runs a program that inherits the input and output of this process, and returns its exit status.
   *
   * @throws IOException when there is no such program, or it cannot be run
   */
  public static int run(
      Outside outside, Job job, List<String> command, Path directory, Map<String, String> env)
      throws IOException {
    outside.confinement().checkProcesses();
    job.identity().take(Resource.PROCESSES);
    try {
      return outside.await(
          job,
          () -> {
            Process process = builder(command, directory, env).inheritIO().start();
            Closeable end = () -> end(process);
            outside.opened(end);
            try {
              return process.waitFor();
            } finally {
              outside.closed(end);
            }
          });
    } finally {
      job.budget().giveBack(Resource.PROCESSES);
    }
  }

  private static ProcessBuilder builder(
      List<String> command, Path directory, Map<String, String> env) {
    ProcessBuilder builder = new ProcessBuilder(command);
    File folder = directory.toFile();
    if (!folder.equals(new File("").getAbsoluteFile())) {
      builder.directory(folder);
    }
    builder.environment().clear();
    builder.environment().putAll(env);
    return builder;
  }

  public PipeSink in() {
    return in;
  }

  public PipeSource out() {
    return out;
  }

  public PipeSource err() {
    return err;
  }

  public boolean isRunning() {
    return status == null;
  }

  /** Makes the job wait until the program has ended. */
  public void join(Job job) {
    waiters.await(job, () -> status != null);
  }

  /** Kills the program, soon, with those that it has begun; what it has written can be read. */
  public void kill() {
    Process running = process;
    if (running != null) {
      // To look for those takes a while.
      outside.start(() -> kill(running));
    }
  }

  /**
   * Kills a process, with those that it has begun, and leaves its streams open: {@link
   * Process#destroyForcibly} closes them, with what nobody has read yet.
   */
  public static void kill(Process process) {
    ProcessTree.kill(process.toHandle());
  }

  /** Nobody reads it any more. */
  static void end(Process process) {
    kill(process);
    process.destroyForcibly();
  }

  /** The status with which it ended; 0 for one that was ended by a signal. */
  public int exitStatus() {
    return signal() == 0 ? status() : 0;
  }

  /** The signal by which it was ended, or 0. */
  public int signal() {
    return signal(status());
  }

  private int status() {
    return requireNonNull(status, "asked for after the end");
  }

  /** The signal encoded in an exit status of the JDK, or 0. */
  public static int signal(int status) {
    int signal = status - SIGNALED;
    return signal > 0 && signal <= LAST_SIGNAL ? signal : 0;
  }
}
