package org.urbi.kernel;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.JobThreads;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.Recorder;
import org.urbi.kernel.journal.RecordingException;
import org.urbi.kernel.journal.RecordingReader;
import org.urbi.kernel.journal.RecordingWriter;
import org.urbi.kernel.journal.Replay;
import org.urbi.kernel.journal.ReplayClock;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.outside.Confinement;
import org.urbi.kernel.outside.RecordingFile;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;
import org.urbi.kernel.time.VirtualClock;

/** How a kernel is to be, and its start. */
public final class KernelBuilder {
  boolean virtualTime;
  JobThreads jobThreads = JobThreads.AUTO;
  List<Path> searchPath = List.of();
  @Nullable Path library;
  List<Path> moduleSearchPath = List.of(Path.of("."));
  int stackSize;
  Duration maxHold = Duration.ZERO;
  long seed;
  String programName = "urbi";
  List<String> arguments = List.of();
  @Nullable IntConsumer onHalt;
  @Nullable Runnable onReboot;
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

  /** Where the run is written down. */
  private record Recording(String name, OutputStream file) {}

  KernelBuilder() {}

  /** Whether time is simulated: nobody waits, and a run depends on its input alone. */
  public KernelBuilder virtualTime(boolean on) {
    virtualTime = on;
    return this;
  }

  /** How jobs are run; by default the fastest way that is available. */
  public KernelBuilder jobThreads(JobThreads how) {
    jobThreads = how;
    return this;
  }

  /** Where source files are looked for, first to last. */
  public KernelBuilder searchPath(List<Path> folders) {
    searchPath = List.copyOf(folders);
    return this;
  }

  /** The folder of the library's own source files: {@code Traceable} may hide their calls. */
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

  /** The stack of a job, in KiB; 0 for as much as there is. It limits nested calls. */
  public KernelBuilder stackSize(int kibibytes) {
    stackSize = kibibytes;
    return this;
  }

  /** Where random numbers begin. */
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

  /** What {@code System._exit} does, with the exit status; by default the kernel just ends. */
  public KernelBuilder onHalt(IntConsumer action) {
    onHalt = action;
    return this;
  }

  /** Has {@code System.reboot} end the kernel, after it has told so. */
  public KernelBuilder onReboot(Runnable action) {
    onReboot = action;
    return this;
  }

  /**
   * Where goes what code evaluated by {@link Kernel#eval} and its like sends to its lobby: whole
   * lines, in general, as a console would show them. By default {@code System.out}. It is called on
   * a thread of its own.
   */
  public KernelBuilder output(Consumer<String> consumer) {
    output = Objects.requireNonNull(consumer);
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
   * Keeps what runs in the kernel away from the machine around it. It can use the files below that
   * directory, links followed, which is also where relative paths start from; it can start no
   * program and open no connection. What is refused is an exception of urbiscript that says so.
   * Folders of the search path elsewhere are not looked into. What is {@link Kernel#define
   * defined}, and who shares the directory, are not confined: links must not change while the
   * kernel runs.
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
   * a run". When that becomes impossible the log is told, and the run goes on.
   *
   * @param file made, or emptied
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
   * Runs a recording again instead of something new: everything that comes from the outside comes
   * from there, and how the kernel was configured. It ends where the recording does; {@link
   * Kernel#replayDifference} says whether it went as it did.
   *
   * @param clients makes the clients that hear the output, of the numbers of the connections
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

  /** Where what comes in is written down, or comes from. */
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
