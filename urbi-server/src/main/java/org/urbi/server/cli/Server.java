package org.urbi.server.cli;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.urbi.bridge.NativeThreads;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.KernelBuilder;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.time.SystemClock;
import org.urbi.server.isolated.IsolatedProcesses;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;
import org.urbi.server.options.Failure;
import org.urbi.server.source.SourceText;
import urbi.ServerConnection;

/** One run of {@code urbi}: starts the kernel and its connections, and ends them. */
final class Server {
  /** Made beforehand: when it is needed, there may be no memory to make it with. */
  private static final byte[] OUT_OF_MEMORY =
      "urbi: memory exhausted, giving up\n".getBytes(StandardCharsets.US_ASCII);

  private static final String BANNER = SourceText.framed("banner", "lobby.banner;");

  private final Settings settings;
  private final PrintStream out;
  private final PrintStream err;
  private final Runnable lastWords;
  private final StartFiles startFiles;
  private int runs;
  private volatile @Nullable Kernel kernel;
  private volatile @Nullable LocalConsole console;
  private volatile boolean reboot;
  private volatile boolean ending;
  private volatile boolean terminated;
  private volatile @Nullable ConsoleServer listening;
  private volatile @Nullable ServerServices services;
  private volatile @Nullable Watchdog watchdog;
  private boolean outputLost;

  /**
   * @param lastWords has the last messages written before the process ends
   */
  Server(Settings settings, PrintStream out, PrintStream err, Runnable lastWords) {
    this.settings = settings;
    this.out = out;
    this.err = err;
    this.lastWords = lastWords;
    startFiles = new StartFiles(settings.searchPath());
  }

  /** Runs until the kernel has been shut down for good, and returns its exit status. */
  int run() {
    int status;
    do {
      reboot = false;
      status = runOnce();
    } while (reboot && !ending);
    if (terminated) {
      return ExitStatus.TERMINATED;
    }
    return outputLost ? ExitStatus.OUTPUT_LOST : status;
  }

  private int runOnce() {
    var modules =
        new IsolatedProcesses(IsolatedProcesses.START_LIMIT, settings.maxHold(), settings.trace());
    var served = new ServerServices(settings);
    services = served;
    Kernel started =
        withFiles(recorded(Kernel.builder().topics(UrbiCommand::optionTexts)))
            .virtualTime(settings.fast())
            .searchPath(settings.searchPath().directories())
            .library(SearchPath.library(SearchPath.root()))
            .moduleSearchPath(settings.moduleSearchPath().directories())
            .stackSize(settings.stackSize())
            .maxHold(settings.maxHold())
            .logLevel(LogLevel.of(settings.trace().level().name()))
            .commandLine(settings.program(), settings.arguments())
            .onHalt(this::halt)
            .onReboot(() -> reboot = true)
            .onMemoryNearlyFull(this::obeySignals)
            .onMemoryExhausted(this::endWithoutMemory)
            .moduleProcesses(modules)
            .services(served)
            .start();
    kernel = started;
    served.begin(started);
    ConsoleServer network = null;
    watch(started);
    // One that a server has left behind would be believed until this one listens.
    removePortFile();
    try {
      recordVariables(served);
      startFiles.loadRos(started, err, System.getenv());
      startFiles.loadGlobal(started, err);
      network = settings.keepsServing() ? listen() : null;
      listening = network;
      if (settings.hasStudio()) {
        openStudio(served);
      }
      if (network != null) {
        // Beside the start, which it would delay.
        FailureLog.THREADS.platform("urbi-heap", ServerHeap::keepRoom).start();
      }
      var local = new LocalConsole(settings, started, this::connect, this::end, out, err);
      console = local;
      local.start();
      int status = started.awaitTermination();
      return status == 0 && settings.strict() && local.hasFailed() ? LocalConsole.FAILED : status;
    } finally {
      started.close();
      served.endRecording();
      modules.close();
      listening = null;
      if (network != null) {
        network.close();
        removePortFile();
      }
      served.close();
      LocalConsole local = console;
      if (local != null) {
        // Its reader may never read: until then SIGTERM must be obeyed.
        local.close();
        outputLost = !settings.keepsServing() && local.isOutputLost();
      }
      watchdog().stop();
      // There is no kernel left to be ended in order.
      obeySignals(true);
    }
  }

  private KernelBuilder withFiles(KernelBuilder builder) {
    Path users = settings.access().userDirectory();
    return users == null ? builder : builder.userDirectory(users);
  }

  private void watch(Kernel watched) {
    Watchdog made =
        new Watchdog(
            new SystemClock(),
            watched,
            this::networkSilence,
            settings.keepsServing() ? settings.watchdog() : Duration.ZERO,
            err,
            this::giveUp);
    watchdog = made;
    made.start();
    obeySignals(false);
  }

  /** Says so without making anything, and ends the process even if that fails. */
  private void endWithoutMemory() {
    try {
      err.write(OUT_OF_MEMORY, 0, OUT_OF_MEMORY.length);
      err.flush();
    } finally {
      giveUp(ExitStatus.MEMORY_EXHAUSTED);
    }
  }

  /**
   * The programs that were started end as well. An orderly halt of the virtual machine waits for
   * whoever halts it already, and until each of its threads has come to a safepoint: one that never
   * comes there would keep the process for ever.
   */
  private void giveUp(int status) {
    try {
      ProcessHandle.current().children().forEach(ProcessHandle::destroyForcibly);
      lastWords.run();
    } finally {
      NativeThreads.exit(status);
    }
  }

  /**
   * Handles SIGTERM. When memory is exhausted no Java code could react, so the signal then ends the
   * process directly.
   */
  private void obeySignals(boolean atOnce) {
    if (atOnce) {
      Signals.endWhenTerminated();
    } else {
      Signals.whenTerminated(this::terminate);
    }
  }

  private void terminate() {
    watchdog().terminating();
    terminated = true;
    ending = true;
    kernel().abort(ExitStatus.TERMINATED);
  }

  private Watchdog watchdog() {
    return requireNonNull(watchdog, "it watches from the start of the kernel");
  }

  private Kernel kernel() {
    return requireNonNull(kernel, "the first one has been started");
  }

  /** How long the network thread has been blocked, in nanoseconds. */
  private long networkSilence() {
    ConsoleServer server = listening;
    return server == null ? 0 : server.silence();
  }

  /** The file of this run: FILE, after a reboot FILE.2. */
  private String ofThisRun(String file) {
    return runs == 1 ? file : file + "." + runs;
  }

  private void recordVariables(ServerServices services) {
    if (settings.mcap() != null) {
      try {
        services.startMcap(Path.of(ofThisRun(settings.mcap())));
      } catch (IOException e) {
        throw Failure.of(e.getMessage());
      }
    }
  }

  /** Makes the kernel record to its own file. */
  private KernelBuilder recorded(KernelBuilder builder) {
    runs++;
    if (settings.record() == null) {
      return builder;
    }
    String file = ofThisRun(settings.record());
    try {
      return builder.record(Path.of(file));
    } catch (UncheckedIOException e) {
      throw Failure.of("cannot write the recording " + file + ": " + Failure.reason(e));
    }
  }

  /** Ends the process at once, after writing pending output. */
  private void halt(int status) {
    ServerServices serving = services;
    if (serving != null) {
      serving.endRecording();
    }
    LocalConsole local = console;
    if (local != null) {
      local.close();
    }
    NativeThreads.halt(status);
  }

  /** Ends the process, whatever it is doing. */
  private void end() {
    ending = true;
    kernel().requestShutdown(0);
  }

  /**
   * Connects a client: sends the banner and loads {@code local.u}.
   *
   * @param holdsTime whether a simulated time waits for the end of this client's input
   */
  private Connection connect(Client client, boolean holdsTime) {
    Connection connection = kernel().connect(client, holdsTime);
    if (!settings.quiet()) {
      connection.send(BANNER);
    }
    startFiles.local().ifPresent(connection::send);
    return connection;
  }

  private ConsoleServer listen() {
    ConsoleServer server =
        new ConsoleServer(
            client -> connect(client, false),
            kernel()::connectRemote,
            limits(),
            settings.access().accessPolicy(),
            settings.trace());
    try {
      if (settings.hasPort()) {
        listenOnPort(server);
      }
      Path socket = settings.socket().file();
      if (socket != null) {
        server.listen(socket, settings.socket().permissions());
        sayListening(socket.toString());
      }
      return server;
    } catch (IOException e) {
      server.close();
      throw Failure.of(e.getMessage());
    } catch (Failure e) {
      server.close();
      throw e;
    }
  }

  private void openStudio(ServerServices services) {
    try {
      String url = services.openStudio(settings.studio());
      kernel().evalAsync("System.studio = \"" + url + "\"|");
    } catch (IOException e) {
      throw Failure.of(e.getMessage() + "; --studio=0 takes any free port");
    }
  }

  private void listenOnPort(ConsoleServer server) {
    InetSocketAddress address = new InetSocketAddress(settings.host(), settings.port());
    if (address.isUnresolved()) {
      throw Failure.of(
          "unknown host: "
              + settings.host()
              + (ServerConnection.isFile(settings.host()) ? " (--socket listens on a file)" : ""));
    }
    String warning = settings.access().checkAddress(address);
    if (warning != null) {
      settings.trace().log(warning);
    }
    settings.access().warnings().forEach(settings.trace()::log);
    try {
      server.listen(address);
    } catch (IOException e) {
      throw Failure.of(e.getMessage() + "; --port 0 takes any free port");
    }
    kernel().evalAsync("System.listenPort = " + server.port() + "|");
    writePortFile(server.port());
    boolean tls = settings.access().accessPolicy().identity() != null;
    sayListening(settings.host() + ":" + server.port() + (tls ? ", by TLS" : ""));
  }

  private void sayListening(String where) {
    if (!settings.quiet()) {
      settings.trace().log("listening on " + where);
    }
  }

  private Limits limits() {
    Limits limits =
        Limits.DEFAULT.withConnections(settings.maxConnections()).withBudget(settings.budget());
    return settings.maxOutput() == 0 ? limits : limits.withTotalOutput(settings.maxOutput());
  }

  /** Writes the file atomically: whoever sees it can read the number. */
  private void writePortFile(int port) {
    Path file = settings.portFile();
    if (file == null) {
      return;
    }
    try {
      Path part = file.resolveSibling(file.getFileName() + ".part");
      Files.writeString(part, port + "\n");
      Files.move(part, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
      // A termination signal ends the process without what follows the end of the kernel.
      file.toFile().deleteOnExit();
    } catch (IOException e) {
      throw Failure.of("cannot write the port file " + file + ": " + e.getMessage());
    }
  }

  private void removePortFile() {
    Path file = settings.portFile();
    try {
      if (file != null && Files.isRegularFile(file)) {
        Files.delete(file);
      }
    } catch (IOException e) {
      settings.trace().debug("cannot remove the port file: " + e.getMessage());
    }
  }
}
