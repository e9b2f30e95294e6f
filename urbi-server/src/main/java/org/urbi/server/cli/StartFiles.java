package org.urbi.server.cli;

import java.io.PrintStream;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.server.source.SourceText;

/**
 * The files that a server loads by itself if it finds them (manual, section 21.2): {@code global.u}
 * once, in a lobby of its own, and {@code local.u} in every lobby.
 */
final class StartFiles {
  /** How long other connections wait for {@code global.u} to end. */
  private static final int TIMEOUT_SECONDS = 5;

  /** What the environment of somebody who uses ROS 1 has, either of them. */
  private static final List<String> ROS = List.of("ROS_MASTER_URI", "ROS_ROOT");

  private static final String LOADED = "urbi-global-loaded";

  private final SearchPath path;

  StartFiles(SearchPath path) {
    this.path = path;
  }

  /**
   * The code that loads {@code local.u}, which every new lobby executes first, if the file exists.
   */
  Optional<String> local() {
    return path.find("local.u").map(file -> SourceText.file(file.toString()));
  }

  /** Loads {@code global.u} and waits for its end; what it prints goes to {@code err}. */
  void loadGlobal(Kernel kernel, PrintStream err) {
    path.find("global.u", "URBI.INI", "CLIENT.INI")
        .ifPresent(file -> load(kernel, err, file.toString(), SourceText.file(file.toString())));
  }

  /** Loads the module of ROS where the environment has one (manual, "Communication with ROS"). */
  void loadRos(Kernel kernel, PrintStream err, Map<String, String> environment) {
    boolean named = ROS.stream().anyMatch(name -> !environment.getOrDefault(name, "").isEmpty());
    if (named) {
      // Its node says when there is no master; nobody waits for that. What scripts choose for it
      // before they use it still counts.
      load(kernel, err, "urbi/ros.u", "requireFile(\"urbi/ros.u\"); detach(Ros.__ahead)|;\n");
    }
  }

  private static void load(Kernel kernel, PrintStream err, String what, String code) {
    GlobalLobbyClient system = new GlobalLobbyClient(err);
    Connection connection = kernel.connect(system, false);
    connection.send(code);
    connection.send("lobby.send(\"\", \"" + LOADED + "\");\n");
    if (!system.awaitLoaded()) {
      err.println("urbi: " + what + " is still running, going on without waiting for it");
    }
  }

  /** The lobby of {@code global.u}, which stays for as long as the kernel. */
  private static final class GlobalLobbyClient implements Client {
    private final PrintStream err;
    private final CompletableFuture<Boolean> loaded = new CompletableFuture<>();

    GlobalLobbyClient(PrintStream err) {
      this.err = err;
    }

    boolean awaitLoaded() {
      return loaded.completeOnTimeout(false, TIMEOUT_SECONDS, TimeUnit.SECONDS).join();
    }

    @Override
    public void output(String bytes) {
      for (String line : bytes.split("(?<=\n)")) {
        if (line.contains(":" + LOADED + "]")) {
          loaded.complete(true);
        } else {
          err.print(line);
        }
      }
    }

    @Override
    public void closed() {
      loaded.complete(true);
    }

    @Override
    public boolean isAwaited() {
      return false;
    }
  }
}
