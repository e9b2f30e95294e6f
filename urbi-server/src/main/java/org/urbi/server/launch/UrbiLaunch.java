package org.urbi.server.launch;

import java.io.PrintStream;
import org.urbi.bridge.NativeThreads;
import org.urbi.server.cli.RawArguments;

/** The program {@code urbi-launch}. */
public final class UrbiLaunch {
  private UrbiLaunch() {}

  public static void main(String[] args) {
    int status = run(RawArguments.of(args), System.out, System.err);
    System.out.flush();
    System.err.flush();
    NativeThreads.halt(status);
  }

  /** Runs the program and returns its exit status. */
  public static int run(String[] args, PrintStream out, PrintStream err) {
    return new ModuleLauncher(ModuleLauncher.Kind.ANY, out, err).run(args);
  }
}
