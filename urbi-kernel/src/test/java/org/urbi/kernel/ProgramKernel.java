package org.urbi.kernel;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.memory.Evictable;
import org.urbi.kernel.memory.MemoryWatchdog;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.trust.Role;

/**
 * A confined kernel in simulated time in which clients come one after the other, each with a
 * program, and leave; a job of nobody's watches them.
 */
final class ProgramKernel implements AutoCloseable {
  /** Simulated: then the client leaves. */
  private static final long STAY = TimeUnit.SECONDS.toNanos(5);

  /** How many turns the jobs of a client may take to end. */
  private static final int TURNS_TO_END = 20;

  /** So many finally clauses, one in the other, may freeze what follows. */
  private static final int CLAUSES = 20;

  /** Real: how long somebody waits before he looks. */
  private static final long WAIT_MS = 100;

  /** After so many waits a program is interrupted, as its client may do. */
  private static final int WAITS_TO_INTERRUPT = 10;

  /**
   * After so many waits the kernel hangs. They are counted, and no clock is read: the whole process
   * may be stopped for a while.
   */
  private static final int WAITS_TO_GIVE_UP = 600;

  /** Runaway recursion ends before what its calls hold fills the memory. */
  private static final int STACK = 20;

  private static final String LIMITS = "jobs=500,timers=500,output=1000000";

  /**
   * What came of a program.
   *
   * @param output all that the client has got, and the log
   * @param defect what is wrong; null for nothing
   * @param interrupted whether it took too long, so that nothing can be compared from here on
   * @param exhausted whether there was no memory for something: which of its steps failed depended
   *     on how much garbage there was, so that nothing can be compared from here on, either
   */
  record Outcome(String output, @Nullable String defect, boolean interrupted, boolean exhausted) {}

  private final Kernel kernel;
  private final StringBuffer heard = new StringBuffer();
  private volatile @Nullable UrbiLobby current;
  private volatile @Nullable Job watching;
  private volatile boolean interrupted;
  private volatile boolean exhausted;
  private volatile int waits;

  ProgramKernel(Path directory) {
    kernel =
        Kernel.builder()
            .virtualTime(true)
            .stackSize(STACK)
            .confinedTo(directory)
            .log(heard::append)
            .logLevel(LogLevel.of("WARN"))
            .onHalt(status -> {})
            .start();
  }

  /** Runs programs until there is a defect, or one that has to be interrupted. */
  List<Outcome> run(List<String> programs, Role role) {
    List<Outcome> outcomes = new ArrayList<>();
    CompletableFuture<Void> over = new CompletableFuture<>();
    kernel.onTermination(
        () -> over.completeExceptionally(new IllegalStateException("the kernel has ended")));
    Scheduler scheduler = kernel.scheduler();
    KernelThread.run(
        kernel,
        () -> {
          // On the thread of the kernel, which is the one that waits.
          scheduler
              .memory()
              .setRelief(() -> {
                exhausted = true;
                MemoryWatchdog.awaitRelief();
              });
          // The lobby of the kernel itself is made when somebody asks for it, and stays.
          kernel.uobjects().lobby();
          Job watcher =
              scheduler.startDetached(
                  kernel.interpreter().world().prototype("Lobby"),
                  scheduler.rootScope(),
                  "watcher",
                  job -> {
                    for (String program : programs) {
                      Outcome outcome = run(job, program, role);
                      outcomes.add(outcome);
                      if (outcome.defect != null || outcome.interrupted) {
                        break;
                      }
                    }
                    over.complete(null);
                  });
          watching = watcher;
          watcher.onEnd(
              () -> over.completeExceptionally(new IllegalStateException("the watcher was ended")));
        });
    try {
      await(over);
    } catch (IllegalStateException e) {
      outcomes.add(new Outcome(heard.toString(), e.getMessage(), true, exhausted));
    }
    return outcomes;
  }

  private void await(CompletableFuture<Void> over) {
    waits = 0;
    while (true) {
      try {
        over.get(WAIT_MS, TimeUnit.MILLISECONDS);
        return;
      } catch (TimeoutException e) {
        waits++;
        if (waits > WAITS_TO_GIVE_UP) {
          throw new IllegalStateException("no end\n" + kernel.holder());
        }
        UrbiLobby lobby = current;
        Job watcher = watching;
        if (lobby != null && watcher != null && waits > WAITS_TO_INTERRUPT) {
          interrupt(lobby, watcher);
        }
      } catch (ExecutionException e) {
        throw new IllegalStateException(e.getCause().getMessage(), e.getCause());
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new IllegalStateException("interrupted", e);
      }
    }
  }

  /** Ends what holds the kernel; the watcher does not wait for the client's jobs any longer. */
  private void interrupt(UrbiLobby lobby, Job waiting) {
    interrupted = true;
    kernel.scheduler().interruptions().request(lobby);
    KernelThread.run(kernel, waiting::wake);
  }

  /** One client; in the job of the watcher. */
  private Outcome run(Job watcher, String program, Role role) {
    heard.setLength(0);
    interrupted = false;
    exhausted = false;
    waits = 0;
    Interpreter interpreter = kernel.interpreter();
    Budget budget = new Budget();
    budget.setLimits(LIMITS);
    UrbiLobby lobby =
        UrbiLobby.start(
            interpreter,
            new Output(kernel.scheduler(), heard::append),
            new Shell.Listener() {
              @Override
              public void consumed() {}

              @Override
              public void finished() {}
            },
            role,
            budget);
    List<Job> before = kernel.scheduler().jobs();
    current = lobby;
    Evictable client = evictable(lobby, watcher);
    kernel.memory().add(client);
    lobby.shell().start();
    lobby.shell().receive(program);
    long end = kernel.scheduler().now() + STAY;
    Timers.Timer timer = kernel.scheduler().timers().add(end, watcher::wake);
    while (kernel.scheduler().now() < end && !interrupted) {
      watcher.waitForWake();
    }
    timer.cancel();
    lobby.shell().close();
    lobby.output().close();
    lobby.disconnected(interpreter, kernel.lobbies());
    int turns = 0;
    while (!jobsBesides(before).isEmpty() && turns < TURNS_TO_END) {
      watcher.yieldNow();
      turns++;
    }
    boolean tooLong = interrupted;
    awaitEnd(watcher, before);
    for (int i = 0; i < CLAUSES && unfreeze(before); i++) {
      awaitEnd(watcher, before);
    }
    for (int i = 0; i < CLAUSES && mayStay(lobby, program, before); i++) {
      lobby.endDetached(interpreter);
      awaitEnd(watcher, before);
    }
    kernel.memory().remove(client);
    current = null;
    kernel.scheduler().interruptions().clear(lobby);
    String output = heard.toString();
    String defect = null;
    if (WrongCallKernel.showsJava(output)) {
      defect = "Java shows";
    } else if (!jobsBesides(before).isEmpty()) {
      defect = "jobs are left: " + jobsBesides(before);
    }
    return new Outcome(output, defect, tooLong || interrupted, exhausted);
  }

  /**
   * What a finally clause does may take its time, also of a program that was interrupted. Then the
   * time of the machine counts, too: whoever still holds the kernel is interrupted again.
   */
  private void awaitEnd(Job watcher, List<Job> before) {
    long end = kernel.scheduler().now() + STAY;
    Timers.Timer timer = kernel.scheduler().timers().add(end, watcher::wake);
    while (kernel.scheduler().now() < end && !jobsBesides(before).isEmpty()) {
      watcher.waitForWake();
    }
    timer.cancel();
  }

  /**
   * A job that is stopped runs its finally clauses, and waits in them at frozen tags as anywhere
   * else (manual, "Tag", {@code freeze}): for somebody who unfreezes these. That is done here, so
   * that whatever is left then waits for something else.
   *
   * @return whether a job was frozen
   */
  private boolean unfreeze(List<Job> before) {
    List<Job> frozen = leftBesides(before).stream().filter(Job::isFrozen).toList();
    for (Job job : frozen) {
      job.unfreezeAlone();
      job.scope().tags().forEach(TagState::unfreeze);
    }
    return !frozen.isEmpty();
  }

  /**
   * Whether all that is left may stay until the budget for what clients leave behind is exceeded,
   * and is ended then: what the client has detached from its connection (disown), and jobs that
   * wait in finally clauses. Only the latter may be left under the connection.
   */
  private boolean mayStay(UrbiLobby lobby, String program, List<Job> before) {
    TagState connection = lobby.connectionTag().state();
    List<Job> left = leftBesides(before);
    return !left.isEmpty()
        && left.stream()
            .filter(job -> job.scope().tags().contains(connection))
            .allMatch(job -> program.contains("finally") && wasToldToEnd(job));
  }

  /** Whether it is under what was told to end, or begun by the cleaning up there. */
  private boolean wasToldToEnd(Job job) {
    TagScope root = kernel.scheduler().rootScope();
    for (TagScope scope = job.scope(); scope != root; scope = scope.parent()) {
      if (scope.isAbandoned()) {
        return true;
      }
    }
    return false;
  }

  /** Whoever fills the memory is ended, as with any client. */
  private Evictable evictable(UrbiLobby lobby, Job watcher) {
    return new Evictable() {
      @Override
      public Budget budget() {
        return lobby.budget();
      }

      @Override
      public String description() {
        return "the program";
      }

      @Override
      public void evict(String why) {
        interrupt(lobby, watcher);
      }

      @Override
      public boolean isAtWork() {
        return false;
      }

      @Override
      public boolean stays() {
        return true;
      }

      @Override
      public void close() {
        throw new UnsupportedOperationException("it stays");
      }
    };
  }

  private List<Job> leftBesides(List<Job> others) {
    return kernel.scheduler().jobs().stream().filter(job -> !others.contains(job)).toList();
  }

  private List<String> jobsBesides(List<Job> others) {
    return leftBesides(others).stream()
        .map(job -> HoldLimit.described(job, null) + ", " + job.state())
        .toList();
  }

  @Override
  public void close() {
    kernel.requestShutdown(0);
    kernel.scheduler().interruptions().requestAll();
  }
}
