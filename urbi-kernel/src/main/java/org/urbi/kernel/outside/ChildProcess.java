package org.urbi.kernel.outside;

import static java.util.Objects.requireNonNull;

import java.io.Closeable;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.message.Message;

/** A running program: its pipes, and its end. Used on the kernel thread. */
public final class ChildProcess {
  /** Shells and the JDK add this to the number of the signal that ended a program. */
  private static final int SIGNALED = 128;

  private static final int LAST_SIGNAL = 64;

  private final WaitingJobs waiters = new WaitingJobs();

  /** Null in a replay. */
  private final @Nullable Process process;

  /** Whose it is. */
  private final Budget budget;

  private final PipeSink in;
  private final PipeSource out;
  private final PipeSource err;
  private @Nullable Integer status;

  private ChildProcess(Outside outside, @Nullable Process process, Budget budget) {
    this.process = process;
    this.budget = budget;
    in = new PipeSink(outside, process == null ? null : process.getOutputStream(), false);
    out = new PipeSource(outside, process == null ? null : process.getInputStream());
    err = new PipeSource(outside, process == null ? null : process.getErrorStream());
    outside.scheduler().pace().begin();
    int number = outside.inbox().register(message -> ended(outside, message));
    if (process != null) {
      // While the process runs, it keeps alive the object that kills it.
      Closeable end = process::destroyForcibly;
      outside.opened(end);
      process
          .onExit()
          .thenRun(() -> {
            outside.closed(end);
            outside.inbox().post(new Message.ProcessEnded(number, process.exitValue()));
          });
    }
  }

  private void ended(Outside outside, Message message) {
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
    job.take(Resource.PROCESSES);
    boolean started = false;
    try {
      Process process = outside.awaitOpen(job, () -> builder(command, directory, env).start());
      started = true;
      return new ChildProcess(outside, process, job.budget());
    } finally {
      if (!started) {
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
    job.take(Resource.PROCESSES);
    try {
      return outside.await(
          job,
          () -> {
            Process process = builder(command, directory, env).inheritIO().start();
            Closeable end = process::destroyForcibly;
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

  /** Kills the program. */
  public void kill() {
    if (process != null) {
      process.destroyForcibly();
    }
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
