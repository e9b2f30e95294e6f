package org.urbi.kernel.outside;

import static java.util.Objects.requireNonNull;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.PendingAnswer;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.message.Outcome;
import org.urbi.kernel.trust.Role;

/**
 * The access of one kernel to the machine: it runs slow operations on threads of their own, so that
 * the kernel thread never waits, and closes everything that is open when the kernel ends.
 */
public final class Outside implements Closeable {
  /** Some milliseconds of waiting without letting others run. */
  private static final int SPINS = 200_000;

  /** After so many it looks whether a timer is due: its owner must not wait for the job. */
  private static final int SPINS_BETWEEN_LOOKS = 1 << 10;

  /** How long to spin for the start of watching directories, which takes the JDK longer once. */
  private static final int WATCH_SPINS = 10_000_000;

  private final Scheduler scheduler;
  private final Confinement confinement;
  private final Confinement users;
  private final Disk disk;
  private final ExecutorService threads =
      FailureLog.THREADS.pool("urbi-outside-", Duration.ofMinutes(1));
  private final Set<Closeable> open = Collections.newSetFromMap(new WeakHashMap<>());
  private volatile @Nullable DirectoryWatch directories;
  private boolean closed;

  /**
   * @param confinement the limits of the kernel
   * @param users the limits of the code of users
   */
  public Outside(Scheduler scheduler, Confinement confinement, Confinement users) {
    this.scheduler = scheduler;
    this.confinement = confinement;
    this.users = users;
    disk = new Disk(this);
  }

  /** The limits of the running code; those of the kernel, when no code runs. */
  public Confinement confinement() {
    Confinement lent = OutsideWork.confinement();
    if (lent != null) {
      return lent;
    }
    Job running = scheduler.isKernelThread() ? scheduler.running() : null;
    if (running == null || running.isOwner()) {
      return confinement;
    }
    return running.identity().role() == Role.USER ? users : Confinement.total();
  }

  /** Whether there is something that the kernel may not do. */
  public boolean isConfined() {
    return confinement.isConfined();
  }

  /**
   * The directory from which relative paths of the running code start.
   *
   * @param otherwise the directory for code that has none of its own
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

  /** Whether the machine is only a recording, so that live objects are null. */
  boolean isReplay() {
    return scheduler.journal().isReplay();
  }

  /**
   * Queries the machine without waiting. The result is data, which is recorded: here if called on
   * the kernel thread; on another thread, with the answer that it sends to the kernel thread.
   *
   * @throws IOException as the work does
   */
  public <T> T query(Outcome.Work<T> work) throws IOException {
    return requireNonNull(look(work), "what is looked at is there");
  }

  private <T> @Nullable T look(Outcome.Work<T> work) throws IOException {
    return scheduler.isKernelThread() ? scheduler.journal().query(work) : Outcome.now(work);
  }

  /**
   * Like {@link #query}, for a live object, such as an open file: null in a replay.
   *
   * @throws IOException as the work does
   */
  <T> @Nullable T open(Outcome.Work<T> work) throws IOException {
    AtomicReference<@Nullable T> opened = new AtomicReference<>();
    change(() -> opened.set(work.run()));
    return opened.get();
  }

  /** A live object that is needed by work which is not executed in a replay. */
  static <T> T live(@Nullable T thing) {
    return requireNonNull(thing, "a replay does nothing to the machine");
  }

  /** A change of the machine, without a result. */
  interface Change {
    void make() throws Exception;
  }

  /**
   * Makes a change that does not wait; in a replay it is not made, but fails if it had failed.
   *
   * @throws IOException as the change does
   */
  void change(Change change) throws IOException {
    look(() -> {
      change.make();
      return null;
    });
  }

  /** Runs a task that may wait for long inside the operating system; not in a replay. */
  public void start(Runnable task) {
    if (isReplay()) {
      return;
    }
    try {
      threads.execute(task);
    } catch (RejectedExecutionException e) {
      // The kernel has ended.
    }
  }

  /**
   * Runs a task that waits for the network on a virtual thread. It is started by way of another
   * thread, because a virtual thread started by a job would run on the kernel thread.
   */
  public void startVirtual(Runnable task) {
    start(() -> FailureLog.THREADS.virtual("urbi-outside-network", task).start());
  }

  /** A number for who is told of the files of directories. */
  public int watcher(DirectoryWatch.Listener listener) {
    return inbox().register(listener::take);
  }

  /**
   * Watches the files of a directory: nothing that happens after the call is missed.
   *
   * @param watcher the number of who is told, once for each file
   * @throws IOException when there is no such directory, or the machine watches no more of them
   */
  public void watch(Job job, Path directory, int watcher) throws IOException {
    outcome(
        job,
        endless(() -> {
          directories().watch(confinement().followed(directory), watcher);
          return null;
        }),
        WATCH_SPINS);
  }

  /** Who has that number is told no more. */
  public void endWatch(int watcher) {
    inbox().forget(watcher);
    DirectoryWatch watching = directories;
    if (watching != null) {
      watching.forget(watcher);
    }
  }

  private synchronized DirectoryWatch directories() throws IOException {
    DirectoryWatch watching = directories;
    if (watching == null) {
      watching = new DirectoryWatch(this);
      directories = watching;
    }
    return watching;
  }

  /**
   * Like {@link #await}, for work so short that other jobs would not notice: usually none of them
   * runs before it is done. Its result may be null.
   *
   * @param file what the work is about: if it is one that makes it wait for others, such as a pipe,
   *     the work ends with the job
   * @throws IOException as the work did
   */
  public <T> @Nullable T awaitBriefly(Job job, Path file, Callable<T> work) throws IOException {
    return outcome(job, new OutsideWork<>(confinement(), file, work), SPINS);
  }

  /**
   * Like {@link #awaitBriefly}, for a live object, such as an open file: null in a replay.
   *
   * @throws IOException as the work did
   */
  public <T> @Nullable T openBriefly(Job job, Path file, Callable<T> work) throws IOException {
    AtomicReference<@Nullable T> opened = new AtomicReference<>();
    outcome(job, new OutsideWork<>(confinement(), file, keeping(opened, work)), SPINS);
    return opened.get();
  }

  /**
   * Runs work on a thread of its own while the job waits and the others run.
   *
   * @throws IOException as the work did
   */
  public <T> T await(Job job, Callable<T> work) throws IOException {
    return requireNonNull(outcome(job, endless(work), 0), "what is waited for is there");
  }

  /**
   * Like {@link #await}, for a live object, such as a started program: null in a replay.
   *
   * @throws IOException as the work did
   */
  <T> @Nullable T awaitOpen(Job job, Callable<T> work) throws IOException {
    AtomicReference<@Nullable T> opened = new AtomicReference<>();
    outcome(job, endless(keeping(opened, work)), 0);
    return opened.get();
  }

  /** The live object does not pass the inbox: who waits has it already when the answer comes. */
  private static <T> Callable<@Nullable T> keeping(
      AtomicReference<@Nullable T> opened, Callable<T> work) {
    return () -> {
      opened.set(work.call());
      return null;
    };
  }

  /** Work that goes on when the job has ended. */
  private <T> OutsideWork<T> endless(Callable<T> work) {
    return new OutsideWork<>(confinement(), null, work);
  }

  private <T> @Nullable T outcome(Job job, OutsideWork<T> work, int spins) throws IOException {
    PendingAnswer answer = new PendingAnswer(job, Wait.FILE);
    AtomicReference<Outcome> early = new AtomicReference<>();
    start(() -> {
      Outcome outcome = Outcome.of(work::call);
      early.set(outcome);
      answer.post(outcome);
    });
    for (int i = 0; i < spins && early.get() == null && !isReplay(); i++) {
      if (i % SPINS_BETWEEN_LOOKS == 0 && scheduler.time().isTimerDue()) {
        break;
      }
      Thread.onSpinWait();
    }
    if (spins == 0 || !query(() -> early.get() != null)) {
      return awaited(answer, work).get();
    }
    answer.abandon();
    return look(() -> requireNonNull(early.get(), "it was there").get());
  }

  /** Work that the job no longer waits for is let go, if it may last for ever. */
  private Outcome awaited(PendingAnswer answer, OutsideWork<?> work) {
    try {
      return answer.await();
    } catch (Throwable stop) {
      if (work.mayBeLetGo()) {
        letGo(work, stop);
      }
      throw stop;
    }
  }

  private void letGo(OutsideWork<?> work, Throwable stop) {
    try {
      start(() ->
          Outcome.of(() -> {
            work.letGo();
            return null;
          }));
    } catch (OutOfMemoryError e) {
      stop.addSuppressed(e);
    }
  }

  /** A property of the Java machine, such as {@code os.name}; empty if it has none. */
  public String property(String name) {
    return scheduler.journal().ask(() -> System.getProperty(name, ""));
  }

  /**
   * The variables of the environment; on the kernel thread, or while the kernel is being made and
   * has none yet.
   */
  public static Map<String, String> environment(Journal journal) {
    return journal.ask(System::getenv);
  }

  /** How much memory the kernel can have, in bytes. */
  public static long memory() {
    return Runtime.getRuntime().maxMemory();
  }

  /** A short text for an I/O error. */
  static String reason(IOException e) {
    return e.getMessage() == null ? Problem.INPUT_OUTPUT.text() : e.getMessage();
  }

  // ------------------------------------------------------------------ the end

  /**
   * Registers an open resource: it is closed when the kernel ends, unless it was garbage collected
   * before.
   */
  public void opened(Closeable resource) {
    synchronized (open) {
      if (!closed) {
        open.add(resource);
        return;
      }
    }
    closeQuietly(resource);
  }

  /** Whoever has closed a resource tells so: it need not be closed with the kernel. */
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

  /** Closes a resource; nobody is left to whom a failure could be reported. */
  static void closeQuietly(Closeable resource) {
    try {
      resource.close();
    } catch (IOException e) {
      // There is nobody to tell.
    }
  }
}
