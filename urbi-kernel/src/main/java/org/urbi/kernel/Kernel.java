package org.urbi.kernel;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobThreads;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.library.KernelControl;
import org.urbi.kernel.library.Library;
import org.urbi.kernel.library.LogLevel;
import org.urbi.kernel.lobby.Shell;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.CorePrototypes;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.World;
import org.urbi.kernel.tag.UrbiTag;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;
import org.urbi.kernel.time.VirtualClock;

/**
 * An urbiscript engine. Several can run in one process, and any thread may use one: what it asks
 * for is done on the kernel's own thread.
 */
public final class Kernel implements AutoCloseable, KernelControl {
  private final Scheduler scheduler;
  private final Interpreter interpreter;
  private final List<Path> searchPath;
  private final Set<KernelConnection> connections = new LinkedHashSet<>();
  private final List<Runnable> onTermination = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Integer> termination = new CompletableFuture<>();
  private final LogLevel logLevel;
  private final Consumer<String> log;
  private final Set<UrbiLobby> created = new LinkedHashSet<>();
  private int status;
  private boolean stopping;

  /** How a kernel is to be. */
  public static final class Builder {
    private boolean virtualTime;
    private JobThreads jobThreads = JobThreads.AUTO;
    private List<Path> searchPath = List.of();
    private int stackSize;
    private long seed;
    private LogLevel logLevel = LogLevel.of(System.getenv("GD_LEVEL"));
    private Consumer<String> log = System.err::println;

    private Builder() {}

    /** Whether time is simulated: nobody waits, and a run depends on its input alone. */
    public Builder virtualTime(boolean on) {
      virtualTime = on;
      return this;
    }

    /** How jobs are run; by default the fastest way that is available. */
    public Builder jobThreads(JobThreads how) {
      jobThreads = how;
      return this;
    }

    /** Where source files are looked for, first to last. */
    public Builder searchPath(List<Path> folders) {
      searchPath = List.copyOf(folders);
      return this;
    }

    /** The stack of a job, in KiB; 0 for as much as there is. It limits nested calls. */
    public Builder stackSize(int kibibytes) {
      stackSize = kibibytes;
      return this;
    }

    /** Where random numbers begin. */
    public Builder seed(long number) {
      seed = number;
      return this;
    }

    /** How much of the log is shown; by default what GD_LEVEL in the environment says. */
    public Builder logLevel(LogLevel most) {
      logLevel = most;
      return this;
    }

    /** Where the log goes, line by line; by default to the standard error stream. */
    public Builder log(Consumer<String> to) {
      log = to;
      return this;
    }

    /** Starts the kernel. */
    public Kernel start() {
      Kernel kernel = new Kernel(this);
      kernel.begin();
      return kernel;
    }
  }

  /** A kernel to be configured, then started. */
  public static Builder builder() {
    return new Builder();
  }

  private Kernel(Builder builder) {
    Clock clock = builder.virtualTime ? new VirtualClock() : new SystemClock();
    World world = new World();
    this.scheduler = new Scheduler(world, clock, builder.jobThreads, this::report);
    this.searchPath = builder.searchPath;
    this.logLevel = builder.logLevel;
    this.log = builder.log;
    var core =
        new CorePrototypes(
            world.values(),
            new UrbiEvent(world.values().object.cloneShape()),
            new UrbiTag(world.values().object.cloneShape()));
    this.interpreter = new Interpreter(world, scheduler, new Errors(world), core);
    interpreter.setHost(this);
    if (builder.stackSize > 0) {
      interpreter.limitDepth(builder.stackSize * CALLS_PER_KIBIBYTE);
    }
    Library.install(interpreter);
  }

  /** How many nested calls a kibibyte of stack stands for. */
  private static final int CALLS_PER_KIBIBYTE = 100;

  private void begin() {
    scheduler.startLoop(this::ended);
  }

  // ------------------------------------------------------------------ life

  @Override
  public void requestShutdown(int exitStatus) {
    scheduler
        .inbox()
        .post(
            () -> {
              if (!stopping) {
                stopping = true;
                status = exitStatus;
                for (KernelConnection connection : new ArrayList<>(connections)) {
                  connection.finish();
                }
                scheduler.stop();
              }
            });
  }

  private void ended() {
    for (KernelConnection connection : new ArrayList<>(connections)) {
      connection.finish();
    }
    onTermination.forEach(Runnable::run);
    termination.complete(status);
  }

  /** Waits for the end of the kernel, and returns its exit status. */
  public int awaitTermination() {
    return termination.join();
  }

  public boolean isRunning() {
    return !termination.isDone();
  }

  /** Runs something when the kernel has ended. */
  public void onTermination(Runnable action) {
    onTermination.add(action);
  }

  /** Ends the kernel, and waits for the end. */
  @Override
  public void close() {
    requestShutdown(0);
    awaitTermination();
  }

  // ------------------------------------------------------------------ connections

  /** Opens a connection: the time stands still, if it is simulated, while more input is to come. */
  public Connection connect(Client client) {
    return connect(client, true);
  }

  /**
   * Opens a connection.
   *
   * @param holdsTime whether a simulated time waits for the input of this connection
   */
  public Connection connect(Client client, boolean holdsTime) {
    KernelConnection connection = new KernelConnection(this, client, holdsTime);
    scheduler.inbox().post(connection::open);
    return connection;
  }

  void add(KernelConnection connection) {
    connections.add(connection);
  }

  void remove(KernelConnection connection) {
    connections.remove(connection);
  }

  Inbox inbox() {
    return scheduler.inbox();
  }

  Scheduler scheduler() {
    return scheduler;
  }

  Interpreter interpreter() {
    return interpreter;
  }

  boolean isStopping() {
    return stopping;
  }

  @Override
  public List<Path> searchPath() {
    return searchPath;
  }

  // ------------------------------------------------------------------ log

  @Override
  public LogLevel logLevel() {
    return logLevel;
  }

  @Override
  public void log(String line) {
    log.accept(line);
  }

  // ------------------------------------------------------------------ lobbies

  @Override
  public List<UrbiLobby> lobbies() {
    List<UrbiLobby> all = new ArrayList<>();
    for (KernelConnection connection : connections) {
      all.add(connection.lobby());
    }
    all.addAll(created);
    return all;
  }

  @Override
  public UrbiLobby createLobby(UrbiLobby creator) {
    UrbiLobby[] made = new UrbiLobby[1];
    Shell.Listener listener =
        new Shell.Listener() {
          @Override
          public void consumed() {}

          @Override
          public void finished() {
            if (created.remove(made[0]) && !stopping) {
              made[0].disconnected(interpreter);
            }
          }
        };
    made[0] = UrbiLobby.start(interpreter, creator.output()::write, listener);
    created.add(made[0]);
    made[0].shell().start();
    return made[0];
  }

  // ------------------------------------------------------------------ errors

  private void report(Job job, Throwable failure) {
    if (job.lobby() instanceof UrbiLobby lobby && lobby.output() != null) {
      ErrorText.report(interpreter, job, lobby, failure);
    }
  }
}
