package org.urbi.server.launch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.urbi.bridge.NativeThreads;
import org.urbi.kernel.log.FailureLog;
import org.urbi.server.cli.RawArguments;
import org.urbi.server.cli.UrbiCommand;

/**
 * The training run for a start-up cache of servers and of the programs that are connected to them:
 * one of each, in one process.
 */
public final class ServerTrainingRun {
  private ServerTrainingRun() {}

  /**
   * @param args a folder with {@code plugged.jar}, which the server loads, and {@code remote.jar},
   *     which runs beside it, and the scripts of the server, which end it
   * @throws IOException if the folder cannot be written to
   */
  public static void main(String[] args) throws IOException {
    String[] words = RawArguments.of(args);
    Path folder = Path.of(words[0]);
    String portFile = folder.resolve("port").toString();
    String remote = folder.resolve("remote.jar").toString();
    String[] component = {"--wait", "--port-file", portFile, remote};
    FailureLog.THREADS
        .platform("urbi-training", () -> UrbiLaunchJava.run(component, System.out, System.err))
        .start();
    // An empty file is no library; but to find that out loads the classes that libraries need.
    Path none = Files.createFile(folder.resolve("none.so"));
    UrbiLaunch.run(new String[] {"--describe", none.toString()}, System.out, System.err);
    List<String> server = new ArrayList<>(List.of("-q", "--port", "0", "--port-file", portFile));
    server.addAll(List.of("-m", folder.resolve("plugged.jar").toString()));
    for (String script : Arrays.asList(words).subList(1, words.length)) {
      server.addAll(List.of("-f", script));
    }
    UrbiCommand.run(server.toArray(String[]::new), System.out, System.err);
    NativeThreads.halt(0);
  }
}
