package org.urbi.server.isolated;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.outside.ChildProcess;
import org.urbi.kernel.remote.ModuleProcess;
import org.urbi.kernel.remote.RemotePeer;
import org.urbi.server.Trace;
import org.urbi.server.net.ModuleNetwork;

/** A process that runs a module: {@link IsolatedModule}. */
final class IsolatedProcess implements ModuleProcess {
  /** How long a process that has lost its connection may take to end by itself. */
  private static final long MILLISECONDS_TO_END = 2000;

  /** How long the last words of a process are waited for: others may hold its streams. */
  private static final long MILLISECONDS_OF_WORDS = 500;

  private static final Map<Integer, String> SIGNALS =
      Map.of(
          4, "SIGILL", 6, "SIGABRT", 7, "SIGBUS", 8, "SIGFPE", 9, "SIGKILL", 11, "SIGSEGV", 13,
          "SIGPIPE", 15, "SIGTERM");

  /** What the launcher has said of the installation. */
  private static final List<String> PROPERTIES =
      List.of("urbi.root", "urbi.uobjects", "urbi.classpath");

  private final Path file;
  private final RemotePeer peer;
  private final ModuleNetwork network;
  private final Duration startLimit;
  private final Duration maxHold;
  private final Trace trace;
  private final Consumer<Thread> begin;
  private final ModuleOutput output;
  private volatile boolean started;
  private @Nullable Process process;
  private @Nullable String killed;

  IsolatedProcess(
      Path file,
      RemotePeer peer,
      ModuleNetwork network,
      Duration startLimit,
      Duration maxHold,
      Trace trace,
      Consumer<Thread> begin) {
    this.file = file;
    this.peer = peer;
    this.network = network;
    this.startLimit = startLimit;
    this.maxHold = maxHold;
    this.trace = trace;
    this.begin = begin;
    output = new ModuleOutput(line -> trace.log(name() + ": " + line));
  }

  private String name() {
    return String.valueOf(file.getFileName());
  }

  @Override
  public void start() {
    try {
      ModuleNetwork.Entrance opened = network.open(peer);
      Process running = start(opened);
      if (running != null) {
        attend(running, opened);
        sendTask(running, opened);
        TimeLimit.after(
            startLimit.toMillis(),
            () -> {
              if (!started) {
                kill(Problem.MODULE_NOT_STARTED.text(startLimit.toSeconds()));
              }
            });
      }
    } catch (IOException e) {
      peer.ended(said(Problem.MODULE_CANNOT_RUN.text(String.valueOf(e.getMessage()))));
    }
  }

  /** Reads what it says, and tells when it has ended; without that it must not run. */
  private void attend(Process running, ModuleNetwork.Entrance opened) {
    Thread reader =
        FailureLog.THREADS.platform(
            "urbi-module-output",
            () -> output.read(running.getInputStream()),
            // It would wait for ever to write what nobody reads.
            defect -> kill(FailureLog.text(defect)));
    Thread end =
        FailureLog.THREADS.platform(
            "urbi-module-end", () -> awaitEnd(running, opened, reader), this::failed);
    try {
      begin.accept(reader);
      begin.accept(end);
    } catch (OutOfMemoryError e) {
      opened.close();
      failed(e);
      throw e;
    }
  }

  private void failed(Throwable defect) {
    kill(FailureLog.text(defect));
    peer.ended(said(FailureLog.text(defect)));
  }

  private synchronized @Nullable Process start(ModuleNetwork.Entrance opened) throws IOException {
    if (killed != null) {
      opened.close();
      peer.ended(said(killed));
      return null;
    }
    try {
      ProcessBuilder builder = new ProcessBuilder(command(opened.port()));
      process = builder.redirectErrorStream(true).start();
      return process;
    } catch (IOException e) {
      opened.close();
      throw e;
    }
  }

  /** Only the process itself can read there; names of files are in UTF-8, whatever the locale. */
  private void sendTask(Process running, ModuleNetwork.Entrance opened) {
    OutputStream in = running.getOutputStream();
    try {
      in.write((opened.token() + "\n" + file + "\n").getBytes(StandardCharsets.UTF_8));
      in.flush();
    } catch (IOException e) {
      // The process has ended already, which says more.
    }
  }

  /**
   * A part of the class path, by a name that another process knows, too: a package names its jars
   * by a descriptor that this one has (scripts/flags.sh).
   */
  private static String known(String jar) {
    if (!jar.startsWith("/proc/self/")) {
      return jar;
    }
    try {
      return Path.of(jar).toRealPath().toString();
    } catch (IOException e) {
      return jar; // Not there: the process tells what it lacks.
    }
  }

  private List<String> command(int port) {
    List<String> jars =
        Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
            .map(IsolatedProcess::known)
            .toList();
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(JvmFlags.inherited());
    command.addAll(
        List.of(
            "-XX:TieredStopAtLevel=1",
            "-XX:-CreateCoredumpOnCrash",
            "-XX:ErrorLogTimeout=5",
            "-XX:ErrorFile=/dev/null"));
    Path cache = Path.of(jars.getFirst()).resolveSibling("../urbi.aot").normalize();
    if (JvmFlags.haveCache() && Files.isRegularFile(cache)) {
      command.add("-XX:AOTCache=" + cache);
    }
    for (String property : PROPERTIES) {
      String value = System.getProperty(property);
      if (value != null) {
        command.add("-D" + property + "=" + value);
      }
    }
    command.addAll(
        List.of(
            "-cp",
            String.join(File.pathSeparator, jars),
            IsolatedModule.class.getName(),
            String.valueOf(port),
            String.valueOf(maxHold.toMillis()),
            name()));
    return command;
  }

  @Override
  public void started() {
    started = true;
  }

  @Override
  public synchronized void kill(String why) {
    if (killed == null) {
      killed = why;
    }
    if (process != null) {
      ChildProcess.kill(process);
    }
  }

  @Override
  public void disconnected(String why) {
    TimeLimit.after(MILLISECONDS_TO_END, () -> kill(why));
  }

  private void awaitEnd(Process running, ModuleNetwork.Entrance opened, Thread reader) {
    try {
      running.waitFor();
      started = true;
      opened.close();
      reader.join(MILLISECONDS_OF_WORDS);
    } catch (InterruptedException e) {
      throw new IllegalStateException("nobody interrupts this thread", e);
    }
    ended(running);
  }

  private void ended(Process gone) {
    StringBuilder text = new StringBuilder(said(how(gone.exitValue())));
    List<String> words = output.lastWords();
    if (!words.isEmpty()) {
      text.append('\n').append(Problem.MODULE_LAST_WORDS.text());
      words.forEach(line -> text.append("\n  ").append(line));
    }
    peer.ended(text.toString());
  }

  private String said(String what) {
    return Problem.MODULE_PROCESS_ENDED.text(name(), what);
  }

  private synchronized String how(int status) {
    String crash = output.crash();
    if (killed != null) {
      return killed;
    }
    if (crash != null) {
      return crash;
    }
    int signal = ChildProcess.signal(status);
    return signal == 0
        ? Problem.EXIT_STATUS.text(status)
        : SIGNALS.getOrDefault(signal, Problem.SIGNAL.text(signal));
  }
}
