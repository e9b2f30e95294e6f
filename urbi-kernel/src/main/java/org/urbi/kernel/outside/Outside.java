package org.urbi.kernel.outside;

import static java.util.Objects.requireNonNull;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.PendingAnswer;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.message.Outcome;
import org.urbi.kernel.trust.Role;

/**
 * What one kernel has to do with the machine around it: threads for what takes time, so that the
 * kernel thread never waits, and everything that is to be closed when the kernel ends.
 */
public final class Outside implements Closeable {
  /** Some milliseconds of waiting without letting others run. */
  private static final int SPINS = 200_000;

  /** As long as it takes the JDK to begin to watch directories; once. */
  private static final int WATCH_SPINS = 10_000_000;

  /** What is allowed to the job for which a thread of the outside works. */
  private static final ScopedValue<Confinement> LENT = ScopedValue.newInstance();

  private final Scheduler scheduler;
  private final Confinement confinement;
  private final Confinement users;
  private final Disk disk;
  private final ExecutorService threads =
      Executors.newCachedThreadPool(
          Thread.ofPlatform().daemon().name("urbi-outside-", 0).factory());
  private final Set<Closeable> open = Collections.newSetFromMap(new WeakHashMap<>());
  private @Nullable DirectoryWatch directories;
  private boolean closed;

  /**
   * @param confinement what is allowed to the kernel
   * @param users what is allowed to the code of users
   */
  public Outside(Scheduler scheduler, Confinement confinement, Confinement users) {
    this.scheduler = scheduler;
    this.confinement = confinement;
    this.users = users;
    disk = new Disk(this);
  }

  /** What is allowed to the code that runs; to the kernel itself, when none does. */
  public Confinement confinement() {
    if (LENT.isBound()) {
      return LENT.get();
    }
    Job running = scheduler.isKernelThread() ? scheduler.running() : null;
    if (running == null || running.isOwner()) {
      return confinement;
    }
    return running.role() == Role.USER ? users : Confinement.total();
  }

  /** Whether there is something that the kernel may not do. */
  public boolean isConfined() {
    return confinement.isConfined();
  }

  /**
   * Where relative paths of the code that runs start from.
   *
   * @param otherwise unless it has a directory of its own
   */
  public Path startOfPaths(Path otherwise) {
    Confinement own = confinement();
    return own == confinement || !own.allowsFiles() ? otherwise : own.workingDirectory();
  }

  /** Files and directories. */
  public Disk disk() {
    return disk;
  }

  public Scheduler scheduler() {
    return scheduler;
  }

  Inbox inbox() {
    return scheduler.inbox();
  }

  /** Whether the rest of the machine is only a recording, and its live things are null. */
  boolean isReplay() {
    return scheduler.journal().isReplay();
  }

  /**
   * What a look at the machine shows, which does not wait: data, which from the kernel thread is
   * written down; from another one its answer will be.
   *
   * @throws IOException as the work does
   */
  public <T> T query(Outcome.Work<T> work) throws IOException {
    return requireNonNull(open(work), "what is looked at is there");
  }

  /**
   * Like {@link #query}, for something live, such as a file that is opened: null in a replay.
   *
   * @throws IOException as the work does
   */
  <T> @Nullable T open(Outcome.Work<T> work) throws IOException {
    return scheduler.isKernelThread() ? scheduler.journal().query(work) : Outcome.of(work).get();
  }

  /** What a look or a change is for: in a replay neither is made. */
  static <T> T live(@Nullable T thing) {
    return requireNonNull(thing, "a replay does nothing to the machine");
  }

  /** Something that is done to the machine, without a result. */
  interface Change {
    void make() throws IOException;
  }

  /**
   * Changes something, which does not wait; in a replay, only its failure is there.
   *
   * @throws IOException as the change does
   */
  void change(Change change) throws IOException {
    open(() -> {
      change.make();
      return null;
    });
  }

  /** Runs something that may wait for long inside the operating system; in a replay it does not. */
  public void start(Runnable task) {
    if (isReplay()) {
      return;
    }
    try {
      threads.execute(FailureLog.guarding("a thread for the outside", task));
    } catch (RejectedExecutionException e) {
      // The kernel has ended.
    }
  }

  /**
   * Runs something that waits for the network. A virtual thread that is started by a job would run
   * on the kernel thread; hence the detour.
   */
  public void startVirtual(Runnable task) {
    Runnable guarded = FailureLog.guarding("a thread for the network", task);
    start(() -> Thread.ofVirtual().start(guarded));
  }

  /**
   * Tells of the files that come and go in a directory from now on: nothing that happens later is
   * missed.
   *
   * @throws IOException when there is no such directory, or the machine watches no more of them
   */
  public void watch(Job job, Path directory, DirectoryWatch.Listener listener) throws IOException {
    int number = inbox().register(listener::take);
    try {
      outcome(
          job,
          () -> {
            directories().watch(confinement().followed(directory), number);
            return null;
          },
          WATCH_SPINS);
    } catch (IOException e) {
      inbox().forget(number);
      throw e;
    }
  }

  private synchronized DirectoryWatch directories() throws IOException {
    if (directories == null) {
      directories = new DirectoryWatch(this);
    }
    return directories;
  }

  /**
   * Like {@link #await}, for work that takes less than the others would notice: as a rule none of
   * them runs before it is done. It may have no result, and none that is live in a replay.
   *
   * @throws IOException as the work did
   */
  public <T> @Nullable T awaitBriefly(Job job, Callable<T> work) throws IOException {
    return outcome(job, work, SPINS);
  }

  /**
   * Has work done on a thread of its own while the job waits, and the others go on.
   *
   * @throws IOException as the work did
   */
  public <T> T await(Job job, Callable<T> work) throws IOException {
    return requireNonNull(awaitOpen(job, work), "what is waited for is there");
  }

  /**
   * Like {@link #await}, for something live, such as a program that is started: null in a replay.
   *
   * @throws IOException as the work did
   */
  <T> @Nullable T awaitOpen(Job job, Callable<T> work) throws IOException {
    return outcome(job, work, 0);
  }

  private <T> @Nullable T outcome(Job job, Callable<T> work, int spins) throws IOException {
    PendingAnswer answer = new PendingAnswer(job);
    AtomicReference<Outcome> early = new AtomicReference<>();
    Confinement allowed = confinement();
    start(() -> {
      Outcome outcome = Outcome.of(() -> ScopedValue.where(LENT, allowed).call(work::call));
      early.set(outcome);
      answer.post(outcome);
    });
    for (int i = 0; i < spins && early.get() == null && !isReplay(); i++) {
      Thread.onSpinWait();
    }
    if (spins == 0 || !query(() -> early.get() != null)) {
      return answer.await().get();
    }
    answer.abandon();
    return open(() -> requireNonNull(early.get(), "it was there").get());
  }

  /** How much memory the kernel can have, in bytes. */
  public static long memory() {
    return Runtime.getRuntime().maxMemory();
  }

  /** What went wrong, in a word. */
  static String reason(IOException e) {
    return e.getMessage() == null ? Problem.INPUT_OUTPUT.text() : e.getMessage();
  }

  // ------------------------------------------------------------------ the end

  /** Something is open: it is closed with the kernel, unless nobody knows it any more. */
  public void opened(Closeable resource) {
    synchronized (open) {
      if (!closed) {
        open.add(resource);
        return;
      }
    }
    closeQuietly(resource);
  }

  /** It is closed. */
  public void closed(Closeable resource) {
    synchronized (open) {
      open.remove(resource);
    }
  }

  /** Closes everything; the kernel has ended. */
  @Override
  public void close() {
    List<Closeable> left;
    synchronized (open) {
      closed = true;
      left = new ArrayList<>(open);
      open.clear();
    }
    left.forEach(Outside::closeQuietly);
    threads.shutdown();
  }

  /** Closes what nobody can be told of any more. */
  static void closeQuietly(Closeable resource) {
    try {
      resource.close();
    } catch (IOException e) {
      // There is nobody to tell.
    }
  }
}
