package org.urbi.kernel;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.JobThreads;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.Recorder;
import org.urbi.kernel.journal.RecordingException;
import org.urbi.kernel.journal.RecordingReader;
import org.urbi.kernel.journal.RecordingWriter;
import org.urbi.kernel.journal.Replay;
import org.urbi.kernel.journal.ReplayClock;
import org.urbi.kernel.library.system.HostServices;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.outside.Confinement;
import org.urbi.kernel.outside.RecordingFile;
import org.urbi.kernel.remote.ModuleProcesses;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;
import org.urbi.kernel.time.VirtualClock;

/** Configures a kernel and starts it. */
public final class KernelBuilder {
  boolean virtualTime;
  JobThreads jobThreads = JobThreads.AUTO;
  List<Path> searchPath = List.of();
  @Nullable Path library;
  List<Path> moduleSearchPath = List.of(Path.of("."));
  int stackSize;
  int tierThreshold = TierSetting.threshold();
  int tierDoubt = TierSetting.doubt();
  Duration maxHold = Duration.ZERO;
  long seed;
  String programName = "urbi";
  List<String> arguments = List.of();
  @Nullable IntConsumer onHalt;
  @Nullable Runnable onReboot;
  private Consumer<Boolean> onMemoryNearlyFull = full -> {};
  private @Nullable Runnable onMemoryExhausted;
  @Nullable ModuleProcesses moduleProcesses;
  HostServices services = HostServices.NONE;
  Consumer<String> output = text -> System.out.print(text);
  LogLevel logLevel = LogLevel.of(System.getenv("GD_LEVEL"));
  Consumer<String> log = System.err::println;
  Confinement confinement = Confinement.none();
  Confinement users = Confinement.total();
  private @Nullable Recording recording;
  @Nullable Replay replay;
  IntFunction<Client> replayed =
      number -> {
        throw new NoSuchElementException("nobody has opened connection " + number);
      };

  Supplier<Map<String, String>> topics = Map::of;

  /** The file in which the run is recorded. */
  private record Recording(String name, OutputStream file) {}

  KernelBuilder() {}

  /**
   * Whether time is simulated: sleeping takes no real time, and a run depends on its input alone.
   */
  public KernelBuilder virtualTime(boolean on) {
    virtualTime = on;
    return this;
  }

  /** How jobs are mapped to threads; by default the fastest way available. */
  public KernelBuilder jobThreads(JobThreads how) {
    jobThreads = how;
    return this;
  }

  /** Where source files are looked for, first to last. */
  public KernelBuilder searchPath(List<Path> folders) {
    searchPath = List.copyOf(folders);
    return this;
  }

  /**
   * The folder of the library's own source files. {@code Traceable} may hide calls made from them
   * in backtraces.
   */
  public KernelBuilder library(Path folder) {
    library = folder;
    return this;
  }

  /** Where modules with UObjects are looked for, first to last. */
  public KernelBuilder moduleSearchPath(List<Path> folders) {
    moduleSearchPath = List.copyOf(folders);
    return this;
  }

  /**
   * How long a job may hold the kernel without letting others run; then an exception ends it that
   * no code catches. By default, and with zero, as long as it likes.
   */
  public KernelBuilder maxHold(Duration limit) {
    maxHold = limit;
    return this;
  }

  /** The stack size of a job, in KiB, which limits nested calls; 0 for no limit of its own. */
  public KernelBuilder stackSize(int kibibytes) {
    stackSize = kibibytes;
    return this;
  }

  /**
   * After how many calls a function, and after ten times as many turns a loop, is compiled; 0 for
   * never, 1 for at once. By default what the property {@code urbi.tier} or the variable URBI_TIER
   * of the environment says, or else 100 (docs/tier.md).
   */
  public KernelBuilder tier(int calls) {
    tierThreshold = calls;
    return this;
  }

  /**
   * Lets compiled code take the slow path each time it has met so many numbers, and forgets one in
   * so many pieces of it as soon as it is made, for tests: nothing changes by it but the time. By
   * default what the property {@code urbi.tier.doubt} says, or else never.
   */
  public KernelBuilder tierDoubt(int period) {
    tierDoubt = period;
    return this;
  }

  /** The seed of the random numbers. */
  public KernelBuilder seed(long number) {
    seed = number;
    return this;
  }

  /** The path under which the program was called, and the arguments of the user's script. */
  public KernelBuilder commandLine(String program, List<String> scriptArguments) {
    programName = program;
    arguments = List.copyOf(scriptArguments);
    return this;
  }

  /**
   * What {@code help} knows besides the library and the language: texts by the names of their
   * topics, such as {@code --port}.
   *
   * @param texts asked on the kernel thread, when somebody wants to know
   */
  public KernelBuilder topics(Supplier<Map<String, String>> texts) {
    topics = texts;
    return this;
  }

  /** What {@code System._exit} does, with the exit status; by default the kernel just ends. */
  public KernelBuilder onHalt(IntConsumer action) {
    onHalt = action;
    return this;
  }

  /** Lets {@code System.reboot} end the kernel, after it has called this action. */
  public KernelBuilder onReboot(Runnable action) {
    onReboot = action;
    return this;
  }

  /**
   * Is told when the memory of the process is nearly exhausted, before lobbies are ended for it,
   * and when it is not any more; on a thread that all kernels of the process share, and which it
   * must not block.
   */
  public KernelBuilder onMemoryNearlyFull(Consumer<Boolean> action) {
    onMemoryNearlyFull = action;
    return this;
  }

  /**
   * What is done when the memory of the process is nearly exhausted, and ending the jobs of all
   * lobbies has not freed it (docs/embedding.md, "Memory"); by default the log tells. It is called
   * again, some ten seconds later, if memory is exhausted still. It must not block, and may be
   * unable to make objects.
   */
  public KernelBuilder onMemoryExhausted(Runnable action) {
    onMemoryExhausted = action;
    return this;
  }

  /**
   * Receives the output of code evaluated by {@link Kernel#eval} and the like: usually whole lines,
   * as a console would show them. By default they go to {@code System.out}. The consumer is called
   * on a thread of its own.
   */
  public KernelBuilder output(Consumer<String> consumer) {
    output = Objects.requireNonNull(consumer);
    return this;
  }

  /**
   * Lets {@code loadModule(module, "isolate")} run modules in processes of their own; without this
   * it fails.
   */
  public KernelBuilder moduleProcesses(ModuleProcesses processes) {
    moduleProcesses = processes;
    return this;
  }

  /** What the program around the kernel does when code asks for it; by default nothing. */
  public KernelBuilder services(HostServices offered) {
    services = offered;
    return this;
  }

  /** How much of the log is shown; by default what GD_LEVEL in the environment says. */
  public KernelBuilder logLevel(LogLevel most) {
    logLevel = most;
    return this;
  }

  /** Where the log goes, line by line; by default to the standard error stream. */
  public KernelBuilder log(Consumer<String> to) {
    log = to;
    return this;
  }

  /**
   * Confines the code that the kernel runs to one directory. It can use files below that directory
   * (symbolic links are resolved first), from which relative paths start; it can start no programs
   * and open no connections. What is refused throws an urbiscript exception that says so. Folders
   * of the search path outside of the directory are skipped. Functions that were {@link
   * Kernel#define defined} by Java are not confined, nor are other users of the directory: links in
   * it must not change while the kernel runs.
   *
   * @throws UncheckedIOException when there is no such directory
   */
  public KernelBuilder confinedTo(Path directory) {
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
  public KernelBuilder userDirectory(Path directory) {
    try {
      users = Confinement.to(directory);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return this;
  }

  /**
   * Writes down the run, so that it can be {@linkplain #replay replayed}: docs/tools.md, "Recording
   * a run". If the file can no longer be written, the log says so and the run continues.
   *
   * @param file is created, or overwritten
   * @throws UncheckedIOException if it cannot be written
   */
  public KernelBuilder record(Path file) {
    try {
      recording = new Recording(file.toString(), RecordingFile.create(file));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return this;
  }

  /**
   * Replays a recording: the configuration of the kernel, and all that came in from the outside,
   * are taken from the file. The kernel ends where the recording ends; {@link
   * Kernel#replayDifference} says whether the replay matched it.
   *
   * @param clients creates, for the number of a connection, the client that receives its output
   * @throws UncheckedIOException if the file cannot be read
   * @throws RecordingException if it is no recording, or damaged
   */
  public KernelBuilder replay(Path file, IntFunction<Client> clients) {
    try {
      replay = new Replay(new RecordingReader(RecordingFile.open(file)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    replayed = clients;
    RecordedSettings.restore(replay.beginning(), this);
    return this;
  }

  /** The journal that records what comes in, or replays it. */
  Journal journal(Clock clock, Consumer<String> trouble) {
    if (replay != null) {
      return replay;
    }
    if (recording == null) {
      return Journal.NONE;
    }
    return new Recorder(
        RecordedSettings.of(this, clock.startTime()),
        new RecordingWriter(recording.name, recording.file, trouble));
  }

  /** What the kernel does when memory runs out. */
  KernelMemory memory(Scheduler scheduler, OutOfBandControl control, KernelLog to) {
    Runnable end = onMemoryExhausted;
    Consumer<Boolean> told = onMemoryNearlyFull;
    return new KernelMemory(
        scheduler.meter(),
        scheduler::turn,
        scheduler::isTurnOf,
        to,
        scheduler.memory().gate()::arm,
        full -> {
          control.hurry(full);
          told.accept(full);
        },
        end == null ? () -> to.write(Problem.MEMORY_GONE.text()) : end);
  }

  /** The time of the machine, of the recording, or none but a simulated one. */
  Clock clock() {
    if (replay != null) {
      return new ReplayClock(replay);
    }
    return virtualTime ? new VirtualClock() : new SystemClock();
  }

  /** Starts the kernel. */
  public Kernel start() {
    Kernel kernel = new Kernel(this);
    kernel.begin(maxHold);
    return kernel;
  }
}
