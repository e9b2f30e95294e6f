package org.urbi.kernel;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.embed.Embedding;
import org.urbi.kernel.embed.JavaValues;
import org.urbi.kernel.embed.Listening;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.kernel.embed.UrbiValue;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobThreads;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.Unwinding;
import org.urbi.kernel.journal.Entry;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.Recorder;
import org.urbi.kernel.journal.RecordingException;
import org.urbi.kernel.journal.RecordingReader;
import org.urbi.kernel.journal.RecordingWriter;
import org.urbi.kernel.journal.Replay;
import org.urbi.kernel.journal.ReplayClock;
import org.urbi.kernel.library.Library;
import org.urbi.kernel.library.LibraryTables;
import org.urbi.kernel.library.code.LoadedFiles;
import org.urbi.kernel.library.code.StackFrames;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.library.file.WorkingDirectory;
import org.urbi.kernel.library.machine.Environment;
import org.urbi.kernel.library.system.CommandLine;
import org.urbi.kernel.library.system.KernelEnd;
import org.urbi.kernel.library.system.SearchPath;
import org.urbi.kernel.lobby.Complaint;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.CorePrototypes;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.World;
import org.urbi.kernel.outside.Confinement;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.outside.RecordingFile;
import org.urbi.kernel.remote.AnswerReading;
import org.urbi.kernel.remote.RemotePeer;
import org.urbi.kernel.remote.RemoteWire;
import org.urbi.kernel.remote.SilentWire;
import org.urbi.kernel.tag.UrbiTag;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;
import org.urbi.kernel.time.VirtualClock;
import org.urbi.kernel.trust.Role;
import org.urbi.kernel.uobject.PluggedContext;
import urbi.UClass;
import urbi.UObject;

/**
 * An urbiscript engine. Several can run in one process, and any thread may use one: what it asks
 * for is done on the kernel's own thread.
 */
public final class Kernel implements AutoCloseable {
  private final Scheduler scheduler;
  private final KernelLog log;
  private final AnswerReading answers;
  private final Interpreter interpreter;
  private final Embedding embedding;
  private final PluggedContext uobjects;
  private final Outside outside;
  private final Journal journal;
  private final Operator operator;

  /** The recording that this kernel runs again, or null. */
  private final Replay replay;

  private final IntFunction<Client> replayed;
  private final IntConsumer onHalt;
  private final Runnable onReboot;
  private final Set<KernelConnection> connections = new LinkedHashSet<>();

  /** Those of which the kernel thread has not been told yet, by their numbers. */
  private final Map<Integer, KernelConnection> arriving = new ConcurrentHashMap<>();

  private final Map<Integer, RemotePeer> arrivingPeers = new ConcurrentHashMap<>();
  private final List<Runnable> onTermination = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Integer> termination = new CompletableFuture<>();
  private int status;
  private boolean stopping;

  /** How a kernel is to be. */
  public static final class Builder {
    private boolean virtualTime;
    private JobThreads jobThreads = JobThreads.AUTO;
    private List<Path> searchPath = List.of();
    private Path library;
    private List<Path> moduleSearchPath = List.of(Path.of("."));
    private int stackSize;
    private Duration maxHold = Duration.ZERO;
    private long seed;
    private String programName = "urbi";
    private List<String> arguments = List.of();
    private IntConsumer onHalt;
    private Runnable onReboot;
    private Consumer<String> output = text -> System.out.print(text);
    private LogLevel logLevel = LogLevel.of(System.getenv("GD_LEVEL"));
    private Consumer<String> log = System.err::println;
    private Confinement confinement = Confinement.none();
    private Confinement users = Confinement.total();
    private OutputStream recording;
    private String recordingName;
    private Replay replay;
    private IntFunction<Client> replayed;

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

    /** The folder of the library's own source files: {@code Traceable} may hide their calls. */
    public Builder library(Path folder) {
      library = folder;
      return this;
    }

    /** Where modules with UObjects are looked for, first to last. */
    public Builder moduleSearchPath(List<Path> folders) {
      moduleSearchPath = List.copyOf(folders);
      return this;
    }

    /**
     * How long a job may hold the kernel without letting others run; then an exception ends it that
     * no code catches. By default, and with zero, as long as it likes.
     */
    public Builder maxHold(Duration limit) {
      maxHold = limit;
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

    /** The path under which the program was called, and the arguments of the user's script. */
    public Builder commandLine(String program, List<String> scriptArguments) {
      programName = program;
      arguments = List.copyOf(scriptArguments);
      return this;
    }

    /** What {@code System._exit} does, with the exit status; by default the kernel just ends. */
    public Builder onHalt(IntConsumer action) {
      onHalt = action;
      return this;
    }

    /** Has {@code System.reboot} end the kernel, after it has told so. */
    public Builder onReboot(Runnable action) {
      onReboot = action;
      return this;
    }

    /**
     * Where goes what code evaluated by {@link Kernel#eval} and its like sends to its lobby: whole
     * lines, in general, as a console would show them. By default {@code System.out}. It is called
     * on a thread of its own.
     */
    public Builder output(Consumer<String> consumer) {
      output = Objects.requireNonNull(consumer);
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

    /**
     * Keeps what runs in the kernel away from the machine around it. It can use the files below
     * that directory, links followed, which is also where relative paths start from; it can start
     * no program and open no connection. What is refused is an exception of urbiscript that says
     * so. Folders of the search path elsewhere are not looked into. What is {@link Kernel#define
     * defined}, and who shares the directory, are not confined: links must not change while the
     * kernel runs.
     *
     * @throws UncheckedIOException when there is no such directory
     */
    public Builder confinedTo(Path directory) {
      try {
        confinement = Confinement.to(directory);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      return this;
    }

    /**
     * Lets code of users (docs/networking.md, "Roles") use the files below that directory; none
     * otherwise. Their relative paths start from there.
     *
     * @throws UncheckedIOException when there is no such directory
     */
    public Builder userDirectory(Path directory) {
      try {
        users = Confinement.to(directory);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      return this;
    }

    /**
     * Writes down the run, so that it can be {@linkplain #replay replayed}: docs/tools.md,
     * "Recording a run". When that becomes impossible the log is told, and the run goes on.
     *
     * @param file made, or emptied
     * @throws UncheckedIOException if it cannot be written
     */
    public Builder record(Path file) {
      try {
        recording = RecordingFile.create(file);
        recordingName = file.toString();
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      return this;
    }

    /**
     * Runs a recording again instead of something new: everything that comes from the outside comes
     * from there, and how the kernel was configured. It ends where the recording does; {@link
     * Kernel#replayDifference} says whether it went as it did.
     *
     * @param clients makes the clients that hear the output, of the numbers of the connections
     * @throws UncheckedIOException if the file cannot be read
     * @throws RecordingException if it is no recording, or damaged
     */
    public Builder replay(Path file, IntFunction<Client> clients) {
      try {
        replay = new Replay(new RecordingReader(RecordingFile.open(file)));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      replayed = clients;
      Entry.Begun begun = replay.beginning();
      seed = begun.seed();
      stackSize = begun.stackSize();
      searchPath = paths(begun.searchPath());
      library = begun.library() == null ? null : Path.of(begun.library());
      moduleSearchPath = paths(begun.modulePath());
      commandLine(begun.programName(), begun.arguments());
      logLevel = LogLevel.of(begun.logLevel());
      confinement = Confinement.recorded(begun.confinedTo(), begun.workingDirectory());
      users =
          begun.userDirectory() == null
              ? Confinement.total()
              : Confinement.recorded(begun.userDirectory(), begun.userDirectory());
      onReboot = begun.reboots() ? () -> {} : null;
      return this;
    }

    private static List<Path> paths(List<String> names) {
      return names.stream().map(Path::of).toList();
    }

    private Journal journal(Clock clock, Consumer<String> trouble) {
      if (replay != null) {
        return replay;
      }
      if (recording == null) {
        return Journal.NONE;
      }
      return new Recorder(
          new Entry.Begun(
              String.valueOf(Kernel.class.getPackage().getImplementationVersion()),
              virtualTime,
              clock.startTime(),
              seed,
              stackSize,
              searchPath.stream().map(Path::toString).toList(),
              library == null ? null : library.toString(),
              moduleSearchPath.stream().map(Path::toString).toList(),
              programName,
              arguments,
              logLevel.name(),
              confinement.isConfined() ? confinement.workingDirectory().toString() : null,
              users.workingDirectory() == null ? null : users.workingDirectory().toString(),
              confinement.workingDirectory().toString(),
              onReboot != null),
          new RecordingWriter(recordingName, recording, trouble));
    }

    /** Starts the kernel. */
    public Kernel start() {
      Kernel kernel = new Kernel(this);
      kernel.begin();
      kernel.operator.setWatch(
          HoldLimit.set(kernel.scheduler, kernel.interpreter.errors(), kernel.log, maxHold));
      return kernel;
    }
  }

  /** A kernel to be configured, then started. */
  public static Builder builder() {
    return new Builder();
  }

  private Kernel(Builder builder) {
    this.log = new KernelLog(builder.logLevel, builder.log);
    this.replay = builder.replay;
    this.replayed = builder.replayed;
    Clock clock = clock(builder);
    this.journal = builder.journal(clock, builder.log);
    World world = new World();
    world.randomness().seed(builder.seed);
    this.scheduler = new Scheduler(world, clock, journal, builder.jobThreads, this::report);
    this.operator = new Operator(scheduler);
    Inbox inbox = scheduler.inbox();
    inbox.register(Message.KERNEL, this::take);
    inbox.setFailures(this::failed);
    this.answers = new AnswerReading();
    inbox.listenTo(answers);
    this.outside = new Outside(scheduler, builder.confinement, builder.users);
    this.onHalt = builder.onHalt == null ? this::requestShutdown : builder.onHalt;
    this.onReboot = builder.onReboot;
    var core =
        new CorePrototypes(
            world.values(),
            new UrbiEvent(world.values().object.cloneShape()),
            new UrbiTag(world.values().object.cloneShape()));
    this.interpreter = new Interpreter(world, scheduler, new Errors(world), core);
    scheduler.whenQuiet(this::endIfNothingCanWakeIt);
    this.uobjects = new PluggedContext(interpreter, builder.moduleSearchPath, outside, log);
    if (builder.stackSize > 0) {
      interpreter.limitDepth(builder.stackSize * CALLS_PER_KIBIBYTE);
    }
    var loadedFiles = new LoadedFiles();
    var stackFrames = new StackFrames(loadedFiles);
    Library.install(interpreter, tables(builder, loadedFiles, stackFrames), stackFrames);
    embedding = new Embedding(interpreter, builder.output, this::isStopping);
  }

  /** The builtins, with what they need of this kernel. */
  private BuiltinTable[] tables(Builder builder, LoadedFiles loadedFiles, StackFrames stackFrames) {
    Path library = builder.library == null ? null : builder.library.toAbsolutePath().normalize();
    return LibraryTables.all(
        new CommandLine(builder.programName, builder.arguments),
        new Environment(environmentAtStart()),
        new FileAccess(outside),
        new End(),
        log,
        loadedFiles,
        new KernelLobbies(this),
        outside,
        uobjects,
        new SearchPath(builder.searchPath, library),
        stackFrames,
        new WorkingDirectory(outside, builder.confinement.workingDirectory()));
  }

  private static Clock clock(Builder builder) {
    if (builder.replay != null) {
      return new ReplayClock(builder.replay);
    }
    return builder.virtualTime ? new VirtualClock() : new SystemClock();
  }

  private Map<String, String> environmentAtStart() {
    try {
      return journal.look(System::getenv);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** How long the jobs have to end in when the kernel is closed, before they are interrupted. */
  private static final int END_PATIENCE_MILLISECONDS = 100;

  /** How many nested calls a kibibyte of stack stands for. */
  private static final int CALLS_PER_KIBIBYTE = 100;

  private void begin() {
    scheduler.startLoop(this::ended);
  }

  // ------------------------------------------------------------------ messages

  private void take(Message message) {
    // As in a connection, no switch over types: every script comes by here.
    if (message instanceof Message.Shutdown wish) {
      shutDown(wish.status());
    } else if (message instanceof Message.ConnectionOpened opened) {
      open(opened);
    } else if (message instanceof Message.RemoteOpened opened) {
      open(opened);
    } else {
      throw new IllegalArgumentException(message.toString());
    }
  }

  private void open(Message.ConnectionOpened opened) {
    int number = opened.connection();
    KernelConnection connection = arriving.remove(number);
    if (connection == null) {
      connection = new KernelConnection(this, number, replayed.apply(number), opened.holdsTime());
    }
    connection.open(opened.address(), Role.valueOf(opened.role()));
  }

  private void open(Message.RemoteOpened opened) {
    RemotePeer peer = arrivingPeers.remove(opened.peer());
    (peer == null ? peer(opened.peer(), opened.name(), new SilentWire()) : peer).open();
  }

  private RemotePeer peer(int number, String name, RemoteWire wire) {
    return new RemotePeer(number, name, scheduler, uobjects, this::describe, answers, wire);
  }

  /** What a message has brought about is our mistake, and no reason for the kernel to end. */
  private void failed(Message message, Throwable failure) {
    FailureLog.internal("a message, " + message.getClass().getSimpleName(), failure);
    for (KernelConnection connection : connections()) {
      if (connection.number() == message.to()) {
        connection.tell(FailureLog.text(failure));
      }
    }
  }

  // ------------------------------------------------------------------ life

  /** Ends the kernel after this tick, with that exit status; may be called from any thread. */
  public void requestShutdown(int exitStatus) {
    if (scheduler.isKernelThread()) {
      shutDown(exitStatus);
    } else {
      scheduler.inbox().post(new Message.Shutdown(exitStatus));
    }
  }

  private void shutDown(int exitStatus) {
    if (!stopping) {
      stopping = true;
      status = exitStatus;
      for (KernelConnection connection : connections()) {
        connection.finish();
      }
      scheduler.stop();
    }
  }

  /**
   * The program has no more input, and nothing is going to happen: no job, no deadline, nothing
   * outside, nobody connected, and no component whose variables and events somebody listens to.
   */
  private void endIfNothingCanWakeIt() {
    for (KernelConnection connection : connections) {
      if (connection.isAwaited()) {
        return;
      }
    }
    boolean resting = scheduler.jobs().stream().allMatch(Job::isResting);
    if (resting && !uobjects.isListenedTo()) {
      connections().forEach(KernelConnection::finishProgram);
    }
  }

  private void ended() {
    for (KernelConnection connection : connections()) {
      connection.finish();
    }
    uobjects.close();
    outside.close();
    embedding.kernelEnded();
    journal.end();
    try {
      onTermination.forEach(Runnable::run);
    } finally {
      termination.complete(status);
    }
  }

  /**
   * Waits for the end of the kernel, and returns its exit status.
   *
   * @throws IllegalStateException on the kernel thread
   */
  public int awaitTermination() {
    embedding.awaitEnd(termination::join);
    return termination.join();
  }

  /** Whether {@link Builder#confinedTo} keeps it away from the machine around it. */
  public boolean isConfined() {
    return outside.isConfined();
  }

  /**
   * How the replay differed from the recorded run, or why it could not go on; null if it did not.
   * Known when the kernel has ended.
   */
  public String replayDifference() {
    return replay == null ? null : replay.difference();
  }

  public boolean isRunning() {
    return !termination.isDone();
  }

  /** Runs something when the kernel has ended. */
  public void onTermination(Runnable action) {
    onTermination.add(action);
  }

  /** Ends the kernel, and waits for the end; except on the kernel thread. */
  @Override
  public void close() {
    requestShutdown(0);
    embedding.close();
    if (!scheduler.isKernelThread()) {
      interruptUnlessEnded();
      awaitTermination();
    }
  }

  /** Code that holds the kernel has a moment to come to its end. */
  private void interruptUnlessEnded() {
    try {
      termination.get(END_PATIENCE_MILLISECONDS, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      scheduler.interruptions().wantAll();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      scheduler.interruptions().wantAll();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }

  // ------------------------------------------------------------------ embedding

  /**
   * Evaluates source text, and waits. It runs as a job in the lobby of this program: what it
   * defines there can be used later, and it may sleep while others run. Like all the methods below
   * it may be called from any thread but the kernel's own.
   *
   * @return the value of the last statement; {@link JavaValues} says what becomes of values
   * @throws UrbiError if the text does not parse, or an exception is not caught
   * @throws IllegalStateException on the kernel thread, or when the kernel has ended; as {@link
   *     java.util.concurrent.CancellationException} if the job was stopped, or the calling thread
   *     interrupted, which stops it
   */
  public Object eval(String source) {
    return embedding.eval(source);
  }

  /**
   * Evaluates source text, and waits.
   *
   * @param type what the value is wanted as: see {@link JavaValues#as}; {@code byte[]} is the bytes
   *     of a String, {@link UrbiValue} a handle on any object
   * @throws ClassCastException if the value cannot be one
   */
  public <T> T eval(String source, Class<T> type) {
    return embedding.eval(source, null, null, type);
  }

  /**
   * Evaluates source text, without waiting; may be called on the kernel thread, too. What depends
   * on the future is executed elsewhere. To cancel the future stops the job.
   */
  public CompletableFuture<Object> evalAsync(String source) {
    return embedding.evalAsync(source);
  }

  /**
   * Calls a function with Java values, and waits.
   *
   * @param function its name in the lobby, or a path: {@code robot.arm.move}
   * @throws IllegalArgumentException if urbiscript has nothing like an argument
   */
  public Object call(String function, Object... arguments) {
    return embedding.call(function, arguments);
  }

  /**
   * Gives urbiscript a function written in Java: everywhere, as a slot of {@code Global}, or by a
   * dotted name as that of another object. It is called on the kernel thread, and the kernel waits
   * for it. What it throws is an exception of urbiscript.
   */
  public void define(String name, Function<? super List<Object>, ?> function) {
    embedding.define(name, function);
  }

  /**
   * Plugs in a class of UObjects of this program, as {@code loadModule} does with those of a jar;
   * it need not call {@code UStart}. May be called from any thread; the constructor runs on the
   * kernel thread.
   *
   * @throws RuntimeException if it cannot be constructed
   */
  public void start(Class<? extends UObject> type) {
    uobjects.start(UClass.of(type));
  }

  /**
   * Listens to an event. The listener gets the payload of each emission, one after the other, on a
   * thread that it may block.
   *
   * @param expression evaluated once, to an event or what has {@code asEvent}
   */
  public Listening onEvent(String expression, Consumer<? super List<Object>> listener) {
    return embedding.onEvent(expression, listener);
  }

  /**
   * Listens to the changes of a slot, as {@code watch} does. The listener gets each new value, one
   * after the other, on a thread that it may block.
   *
   * @param slot its name in the lobby, a path, or any expression to watch
   */
  public Listening onChange(String slot, Consumer<Object> listener) {
    return embedding.onChange(slot, listener);
  }

  /** What the methods above stand on, for those who need more. */
  public Embedding embedding() {
    return embedding;
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
    int number = scheduler.inbox().reserve();
    KernelConnection connection = new KernelConnection(this, number, client, holdsTime);
    arriving.put(number, connection);
    scheduler
        .inbox()
        .post(
            new Message.ConnectionOpened(
                number, holdsTime, client.remoteAddress(), client.role().name()));
    return connection;
  }

  /** For how long a job has held the kernel, in nanoseconds; if {@link Builder#maxHold} is set. */
  public long heldFor() {
    return operator.heldFor();
  }

  /** What holds the kernel, for people, with its Java stack. */
  public String holder() {
    return operator.holder();
  }

  /**
   * Memory is nearly exhausted: ends all that the lobby does which uses the kernel most, and tells
   * its client. To be called on a thread of one's own.
   *
   * @return which one it was, for people
   */
  public String relieve() throws InterruptedException {
    return operator.relieve();
  }

  /** Ends the kernel as soon as possible, whatever its jobs do; from any thread. */
  public void abort(int exitStatus) {
    requestShutdown(exitStatus);
    scheduler.interruptions().wantAll();
  }

  Operator operator() {
    return operator;
  }

  void add(KernelConnection connection) {
    connections.add(connection);
    operator.add(connection);
  }

  void remove(KernelConnection connection) {
    connections.remove(connection);
    operator.remove(connection);
  }

  /** Those that are open, oldest first. */
  List<KernelConnection> connections() {
    return List.copyOf(connections);
  }

  Inbox inbox() {
    return scheduler.inbox();
  }

  Scheduler scheduler() {
    return scheduler;
  }

  Journal journal() {
    return journal;
  }

  Interpreter interpreter() {
    return interpreter;
  }

  boolean isStopping() {
    return stopping;
  }

  /** The UObjects in this kernel, and where more of them can be started. */
  public PluggedContext uobjects() {
    return uobjects;
  }

  /**
   * Lets a process bring UObjects (docs/protocol.md).
   *
   * @param name of the process, for people
   * @param wire the way to it
   */
  public RemotePeer connectRemote(String name, RemoteWire wire) {
    int number = scheduler.inbox().reserve();
    RemotePeer peer = peer(number, name, wire);
    arrivingPeers.put(number, peer);
    scheduler.inbox().post(new Message.RemoteOpened(number, name));
    return peer;
  }

  /** What went wrong, for people; in a job. */
  private String describe(RuntimeException failure) {
    if (failure instanceof UrbiException thrown) {
      Job job = scheduler.running();
      return interpreter.asString(
          Frame.top(interpreter, job, job.lobby(), new FrameLayout()), thrown.value());
    }
    return failure.getMessage() == null ? failure.toString() : failure.getMessage();
  }

  // ------------------------------------------------------------------ for the library

  private final class End implements KernelEnd {
    @Override
    public void requestShutdown(int exitStatus) {
      Kernel.this.requestShutdown(exitStatus);
    }

    @Override
    public void halt(int exitStatus) {
      journal.end();
      onHalt.accept(exitStatus);
    }

    @Override
    public boolean requestReboot() {
      if (onReboot == null) {
        return false;
      }
      onReboot.run();
      requestShutdown(0);
      return true;
    }
  }

  // ------------------------------------------------------------------ errors

  /**
   * Tells of what nobody has caught.
   *
   * @param job null if it was thrown between the turns of the jobs
   */
  private void report(Job job, Throwable failure) {
    if (job == null) {
      FailureLog.internal("the kernel thread", failure);
      return;
    }
    if (ErrorText.isInternal(failure)) {
      FailureLog.internal("job " + job.name(), failure);
    }
    if (job.lobby() instanceof UrbiLobby lobby && lobby.output() != null) {
      if (lobby.shell() != null && !(failure instanceof Unwinding)) {
        lobby.shell().failed();
      }
      try {
        ErrorText.report(interpreter, job, lobby, failure);
      } catch (Unwinding unwinding) {
        throw unwinding;
      } catch (Throwable unable) {
        FailureLog.internal("showing an error", unable);
        Complaint.error(lobby.output(), FailureLog.text(unable));
      }
    }
  }
}
