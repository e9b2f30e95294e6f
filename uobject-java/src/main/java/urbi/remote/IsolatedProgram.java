package urbi.remote;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import urbi.Log;
import urbi.ServerConnection;
import urbi.TokenLine;
import urbi.UClientException;
import urbi.UModule;
import urbi.UModuleException;
import urbi.spi.Failure;
import urbi.spi.ModuleFiles;
import urbi.thread.GuardedThreads;
import urbi.thread.InternalFailure;
import urbi.wire.Frame;

/**
 * A process in which the kernel runs one module (docs/robustness.md, "Modules in processes of their
 * own"). Its standard input is a pipe from the kernel's process: first come two lines, with the
 * token for the connection and the file of the module, then nothing, until that process ends.
 */
public final class IsolatedProgram {
  private final int port;
  private final Duration limit;
  private final InputStream in;
  private final Runnable halt;

  /**
   * @param port of this machine, where the kernel waits for the process
   * @param limit how long code of the module may hold up the other code of it; zero for any time
   * @param in the standard input
   * @param halt ends the process, whatever it does
   */
  public IsolatedProgram(int port, Duration limit, InputStream in, Runnable halt) {
    this.port = port;
    this.limit = limit;
    this.in = in;
    this.halt = halt;
  }

  /**
   * Runs the module until the connection ends, and tells why it did.
   *
   * @throws IOException if it is not told what to do
   * @throws UClientException if there is no connection
   */
  public String run() throws IOException {
    String token = line();
    Path file = Path.of(line());
    GuardedThreads.SDK.platform("urbi-isolated-input", this::awaitEndOfInput).start();
    try (RemoteContext context = connect(token)) {
      start(context, file);
      if (limit.isPositive()) {
        GuardedThreads.SDK
            .platform(
                "urbi-isolated-limit",
                () -> watch(context),
                defect -> tell(context, InternalFailure.text(defect)))
            .start();
      }
      return context.onClosed().join();
    }
  }

  private String line() throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    for (int c = in.read(); c != '\n'; c = in.read()) {
      if (c < 0) {
        throw new IOException("this program is run by a kernel");
      }
      line.write(c);
    }
    return line.toString(StandardCharsets.UTF_8);
  }

  /** The kernel's process has ended, in whatever way: so does this one. */
  private void awaitEndOfInput() {
    try {
      in.transferTo(OutputStream.nullOutputStream());
    } catch (IOException e) {
      // That is an end, too.
    } finally {
      halt.run();
    }
  }

  /** Connects; afterwards the properties are as they were, for clients in the module. */
  private RemoteContext connect(String token) {
    System.setProperty(TokenLine.PROPERTY, token);
    System.setProperty(ServerConnection.TLS_PROPERTY, "no");
    try {
      return RemoteContext.ofModule(port);
    } finally {
      System.clearProperty(TokenLine.PROPERTY);
      System.clearProperty(ServerConnection.TLS_PROPERTY);
    }
  }

  /** Loads the module, starts its classes, and tells the kernel. */
  private static void start(RemoteContext context, Path file) {
    String problem = "";
    try {
      UModule module =
          context.inTurn("the start of " + file.getFileName(), () -> ModuleFiles.load(file));
      module.startIn(context);
    } catch (UClientException e) {
      throw e;
    } catch (UModuleException e) {
      problem = String.valueOf(e.getMessage());
    } catch (Throwable e) {
      String what = "exception caught while starting " + file.getFileName();
      Log.error(what, e);
      problem = what + ": " + Failure.text(e);
    }
    tell(context, problem);
  }

  private static void tell(RemoteContext context, String problem) {
    context.sendNow(out -> out.begin(Frame.MODULE).text(problem).end());
  }

  /** Tells the kernel, which ends the process then, when its code holds up the rest of it. */
  private void watch(RemoteContext context) {
    long most = limit.toNanos();
    while (!context.onClosed().isDone()) {
      LockSupport.parkNanos(this, Math.clamp(most / 8, 1_000_000, 250_000_000));
      String slow = context.turn().longerThan(most);
      if (slow != null) {
        tell(context, slow + " has not returned for " + seconds(limit));
        return;
      }
    }
  }

  private static String seconds(Duration time) {
    return time.toMillis() % 1000 == 0 ? time.toSeconds() + " s" : time.toMillis() + " ms";
  }
}
