package org.urbi.kernel;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.embed.Embedding;
import org.urbi.kernel.embed.JavaValues;
import org.urbi.kernel.embed.ListenerRegistration;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.kernel.embed.UrbiValue;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.Replay;
import org.urbi.kernel.library.Library;
import org.urbi.kernel.library.LibraryTables;
import org.urbi.kernel.library.code.LoadedFiles;
import org.urbi.kernel.library.code.StackFrames;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.library.file.WorkingDirectory;
import org.urbi.kernel.library.machine.Environment;
import org.urbi.kernel.library.reference.Topics;
import org.urbi.kernel.library.system.CommandLine;
import org.urbi.kernel.library.system.SearchPath;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.log.LogLines;
import org.urbi.kernel.memory.MemoryWatchdog;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.CorePrototypes;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.World;
import org.urbi.kernel.observe.Interventions;
import org.urbi.kernel.observe.KnownEvents;
import org.urbi.kernel.observe.Places;
import org.urbi.kernel.observe.Steering;
import org.urbi.kernel.outside.HeapUsage;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.remote.AnswerPoller;
import org.urbi.kernel.remote.IsolatedModules;
import org.urbi.kernel.remote.RemotePeer;
import org.urbi.kernel.remote.RemoteTransport;
import org.urbi.kernel.tag.UrbiTag;
import org.urbi.kernel.tier.Tier;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.uobject.PluggedContext;
import urbi.UObject;

/**
 * An urbiscript engine. Several can run in one process, and any thread may use one: its requests
 * are carried out on the kernel's own thread.
 */
public final class Kernel implements AutoCloseable {
  /** How many nested calls are allowed for each kibibyte of stack. */
  private static final int CALLS_PER_KIBIBYTE = 100;

  private final Scheduler scheduler;
  private final LogLines logLines;
  private final KernelLog log;
  private final Interpreter interpreter;
  private final LoadedFiles loadedFiles;
  private final Embedding embedding;
  private final PluggedContext uobjects;
  private final Outside outside;
  private final Journal journal;
  private final OutOfBandControl outOfBand;
  private final KernelMemory memory;
  private final Connections connections;
  private final KernelLobbies lobbies;
  private final DepartedClients departed;
  private final KernelLifecycle life;
  private final Steering steering;
  private final Places places;
  private final KnownEvents knownEvents;
  private final Interventions interventions;

  /** The recording that this kernel replays, or null. */
  private final @Nullable Replay replay;

  /** A kernel to be configured, then started. */
  public static KernelBuilder builder() {
    return new KernelBuilder();
  }

  Kernel(KernelBuilder builder) {
    this.logLines = new LogLines(builder.log);
    this.log = new KernelLog(builder.logLevel, logLines);
    this.replay = builder.replay;
    Clock clock = builder.clock();
    this.journal = builder.journal(clock, builder.log);
    World world = new World();
    world.randomNumbers().seed(builder.seed);
    this.scheduler = new Scheduler(world, clock, journal, builder.jobThreads, this::report);
    this.lobbies = new KernelLobbies(this);
    this.departed = new DepartedClients(this, log);
    this.outOfBand = new OutOfBandControl(scheduler, departed);
    this.memory = builder.memory(scheduler, outOfBand, log);
    Inbox inbox = scheduler.inbox();
    inbox.register(Message.KERNEL, this::take);
    var answers = new AnswerPoller();
    inbox.listenTo(answers);
    this.connections = new Connections(this, outOfBand, answers, builder.replayed);
    inbox.setFailures(connections::failed);
    this.outside = new Outside(scheduler, builder.confinement, builder.users);
    this.life =
        new KernelLifecycle(
            scheduler,
            connections::lookLast,
            connections::finish,
            builder.onHalt,
            builder.onReboot);
    var core =
        new CorePrototypes(
            world.values(),
            new UrbiEvent(world.values().object.cloneShape()),
            new UrbiTag(world.values().object.cloneShape()));
    this.interpreter = new Interpreter(world, scheduler, new Errors(world), core);
    if (builder.tierThreshold > 0) {
      interpreter.setCompiler(new Tier(world, builder.tierThreshold, builder.tierDoubt, log));
    }
    scheduler.time().whenQuiet(this::endIfNothingCanWakeIt);
    this.steering = new Steering(scheduler, world.values().voidObject);
    this.uobjects = new PluggedContext(interpreter, builder.moduleSearchPath, outside, log);
    uobjects
        .modules()
        .setIsolation(
            new IsolatedModules(
                uobjects, outside, connections::expectRemote, builder.moduleProcesses));
    if (builder.stackSize > 0) {
      interpreter.limitDepth(builder.stackSize * CALLS_PER_KIBIBYTE);
    }
    loadedFiles = new LoadedFiles();
    var stackFrames = new StackFrames(world, loadedFiles);
    Library.install(interpreter, tables(builder, stackFrames), stackFrames);
    places = new Places(world.prototype("Global"), lobbies::all);
    knownEvents = new KnownEvents(scheduler, places, world.values().object);
    interventions = new Interventions(interpreter, knownEvents, places);
    embedding = new Embedding(interpreter, builder.output, this::isStopping);
    memory.add(embedding.evictable());
  }

  /** The builtins, with what they need of this kernel. */
  private BuiltinTable[] tables(KernelBuilder builder, StackFrames stackFrames) {
    Path library = builder.library == null ? null : builder.library.toAbsolutePath().normalize();
    return LibraryTables.all(
        new CommandLine(builder.programName, builder.arguments),
        new Environment(Outside.environment(journal)),
        new FileAccess(outside),
        builder.services,
        log,
        loadedFiles,
        lobbies,
        outside,
        uobjects,
        new SearchPath(builder.searchPath, library),
        life,
        stackFrames,
        new Topics(builder.topics),
        new WorkingDirectory(outside, builder.confinement.workingDirectory()));
  }

  /** Starts to run. */
  void begin(Duration maxHold) {
    // A replayed kernel does what the recorded one has done, and hears of nothing else.
    if (!journal.isReplay()) {
      MemoryWatchdog.add(memory);
      scheduler.memory().setRelief(MemoryWatchdog::awaitRelief);
      scheduler.memory().setLook(MemoryWatchdog::awaitLook);
      scheduler.memory().gate().setMemory(HeapUsage::free, HeapUsage.all());
    }
    scheduler.startLoop(this::ended);
    outOfBand.setWatch(HoldLimit.set(scheduler, interpreter.errors(), log, maxHold));
  }

  // ------------------------------------------------------------------ messages

  private void take(Message message) {
    // No pattern switch, for the reason given in KernelConnection: every script starts here.
    if (message instanceof Message.Shutdown wish) {
      life.requestShutdown(wish.status());
    } else if (message instanceof Message.ConnectionOpened opened) {
      connections.open(opened);
    } else if (message instanceof Message.RemoteOpened opened) {
      connections.open(opened);
    } else {
      throw new IllegalArgumentException(message.toString());
    }
  }

  // ------------------------------------------------------------------ life

  /** Ends the kernel with that exit status, soon; may be called from any thread. */
  public void requestShutdown(int exitStatus) {
    life.wishShutdown(exitStatus);
  }

  /**
   * Ends the kernel if the program has no more input and nothing can happen any more: there is no
   * job, no deadline, no activity outside, no connection, and no component whose variables and
   * events somebody listens to.
   */
  private void endIfNothingCanWakeIt() {
    if (connections.areAwaited()) {
      return;
    }
    boolean resting = scheduler.jobs().stream().allMatch(Job::isDaemon);
    if (resting && !uobjects.isListenedTo()) {
      connections.all().forEach(KernelConnection::finishProgram);
    }
  }

  private void ended(Throwable failure) {
    MemoryWatchdog.remove(memory);
    outOfBand.end();
    connections.finish();
    uobjects.close();
    outside.close();
    embedding.kernelEnded();
    journal.end();
    life.ended(failure);
  }

  /**
   * Waits for the end of the kernel, and returns its exit status.
   *
   * @throws IllegalStateException on the kernel thread
   */
  public int awaitTermination() {
    embedding.awaitEnd(life::await);
    return life.await();
  }

  /** Whether {@link KernelBuilder#confinedTo} keeps it away from the machine around it. */
  public boolean isConfined() {
    return outside.isConfined();
  }

  /**
   * How the replay differed from the recorded run, or why it could not go on; null if it did not.
   * Known when the kernel has ended.
   */
  public @Nullable String replayDifference() {
    return replay == null ? null : replay.difference();
  }

  public boolean isRunning() {
    return !life.hasEnded();
  }

  /** Runs something when the kernel has ended. */
  public void onTermination(Runnable action) {
    life.onTermination(action);
  }

  /** Ends the kernel, and waits for the end; except on the kernel thread. */
  @Override
  public void close() {
    requestShutdown(0);
    embedding.close();
    if (!scheduler.isKernelThread()) {
      life.interruptUnlessEnded();
      awaitTermination();
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
  public @Nullable Object eval(String source) {
    return embedding.eval(source);
  }

  /**
   * Evaluates source text, and waits.
   *
   * @param type what the value is wanted as: see {@link JavaValues#as}; {@code byte[]} is the bytes
   *     of a String, {@link UrbiValue} a handle on any object
   * @throws ClassCastException if the value cannot be one
   */
  public <T> @Nullable T eval(String source, Class<T> type) {
    return embedding.eval(source, null, null, type);
  }

  /**
   * Evaluates source text, without waiting; may be called on the kernel thread, too. Actions that
   * depend on the future do not run on the kernel thread. Cancelling the future stops the job.
   */
  public CompletableFuture<Object> evalAsync(String source) {
    return embedding.evalAsync(source);
  }

  /**
   * Calls a function with Java values, and waits.
   *
   * @param function its name in the lobby, or a path: {@code robot.arm.move}
   * @throws IllegalArgumentException if an argument cannot be converted to an urbiscript value
   */
  public @Nullable Object call(String function, Object... arguments) {
    return embedding.call(function, arguments);
  }

  /**
   * Gives urbiscript a function written in Java: visible everywhere, as a slot of {@code Global},
   * or with a dotted name as a slot of another object. It is called on the kernel thread, which
   * waits for it. What it throws becomes an urbiscript exception.
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
    uobjects.start(type);
  }

  /**
   * Listens to an event. The listener gets the payload of each emission, one after the other, on a
   * thread that it may block.
   *
   * @param expression evaluated once; its value is an event, or an object with {@code asEvent}
   */
  public ListenerRegistration onEvent(String expression, Consumer<? super List<Object>> listener) {
    return embedding.onEvent(expression, listener);
  }

  /**
   * Listens to the changes of a slot, as {@code watch} does. The listener gets each new value, one
   * after the other, on a thread that it may block.
   *
   * @param slot its name in the lobby, a path, or any expression to watch
   */
  public ListenerRegistration onChange(String slot, Consumer<Object> listener) {
    return embedding.onChange(slot, listener);
  }

  /** The full interface for Java programs, of which the methods above are shortcuts. */
  public Embedding embedding() {
    return embedding;
  }

  // ------------------------------------------------------------------ connections

  /** Opens a connection. Simulated time stands still until its input has ended. */
  public Connection connect(Client client) {
    return connect(client, true);
  }

  /**
   * Opens a connection.
   *
   * @param holdsTime whether simulated time stands still while this connection may send input
   */
  public Connection connect(Client client, boolean holdsTime) {
    return connections.connect(client, holdsTime);
  }

  /**
   * For how long the running job has held the kernel, in nanoseconds. Without {@link
   * KernelBuilder#maxHold} that is measured from the first time on that somebody asks.
   */
  public long heldFor() {
    return outOfBand.heldFor();
  }

  /** What holds the kernel, for people, with its Java stack. */
  public String holder() {
    return outOfBand.holder();
  }

  /**
   * Ends the kernel as soon as possible, whatever its jobs are doing. May be called from any
   * thread.
   */
  public void abort(int exitStatus) {
    requestShutdown(exitStatus);
    scheduler.interruptions().requestAll();
  }

  OutOfBandControl outOfBand() {
    return outOfBand;
  }

  Steering steering() {
    return steering;
  }

  Places places() {
    return places;
  }

  KnownEvents knownEvents() {
    return knownEvents;
  }

  Interventions interventions() {
    return interventions;
  }

  KernelMemory memory() {
    return memory;
  }

  Connections connections() {
    return connections;
  }

  KernelLobbies lobbies() {
    return lobbies;
  }

  DepartedClients departed() {
    return departed;
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

  LogLines logLines() {
    return logLines;
  }

  Interpreter interpreter() {
    return interpreter;
  }

  boolean isStopping() {
    return life.isStopping();
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
  public RemotePeer connectRemote(String name, RemoteTransport wire) {
    return connections.connectRemote(name, wire);
  }

  private void report(Job job, Throwable failure) {
    ErrorText.tell(interpreter, loadedFiles, job, failure);
  }
}
