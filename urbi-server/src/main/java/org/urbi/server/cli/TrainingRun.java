package org.urbi.server.cli;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.urbi.bridge.NativeThreads;

/**
 * The training run with which the build makes the start-up cache: short scripts, in real and in
 * simulated time. The JDK caches the classes that they load. The run leaves out what a short script
 * does not need, such as the network, because a larger cache makes every start slower.
 */
public final class TrainingRun {
  private final PrintStream nowhere =
      new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);

  private TrainingRun() {}

  /**
   * @param args a script to be run, which must not end the server
   */
  public static void main(String[] args) {
    String script = RawArguments.of(args)[0];
    TrainingRun trainingRun = new TrainingRun();
    trainingRun.urbi("-q", "-e", "echo(\"Hello, World!\");", "-e", "shutdown;");
    trainingRun.urbi("--quiet", "--fast", script);
    trainingRun.urbi("--help");
    trainingRun.urbi("--version");
    // As every run of urbi ends: the class of that is to be cached, too.
    NativeThreads.halt(0);
  }

  private void urbi(String... args) {
    new UrbiCommand(nowhere, System.err).run(args);
  }
}
