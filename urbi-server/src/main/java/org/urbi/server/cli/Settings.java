package org.urbi.server.cli;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.lobby.ErrorStyle;
import org.urbi.server.Trace;
import org.urbi.server.studio.Shown;
import org.urbi.server.trust.AccessOptions;

/**
 * The settings from the command line of {@code urbi}.
 *
 * @param moduleSearchPath where UObjects are looked for
 * @param fast whether time is simulated
 * @param stackSize of a job, in KiB; 0: the kernel's choice
 * @param maxHold how long a job may hold the kernel; zero for as long as it likes
 * @param watchdog how long kernel and network of a server may not turn before it gives up; zero for
 *     as long as they like
 * @param quiet whether clients are not sent a banner
 * @param errors how the console tells of errors
 * @param port where to listen; 0 for any, {@link #NO_PORT} for nowhere
 * @param portFile where to write the port's number, or null
 * @param studio the port of the studio; 0 for any, {@link #NO_PORT} without it
 * @param shown what other programs than browsers are shown by it, and recorded in the MCAP file
 * @param mcap where to record variables, or null
 * @param socket where to listen besides
 * @param maxConnections how many clients there may be at a time; 0: any number
 * @param maxOutput how many bytes may wait for all clients together; 0: the default
 * @param budget what the lobby of a client may have
 * @param access who is let in, and as what
 * @param record where to record the run, or null
 * @param strict whether the exit status tells of errors even after {@code shutdown}
 * @param text what the console's lobby is sent first
 * @param input where more of it comes from
 * @param program the path under which it was called
 * @param arguments what the script is told of the command line
 */
record Settings(
    Trace trace,
    SearchPath searchPath,
    SearchPath moduleSearchPath,
    boolean fast,
    int stackSize,
    Duration maxHold,
    Duration watchdog,
    boolean quiet,
    ErrorStyle errors,
    String host,
    int port,
    @Nullable Path portFile,
    int studio,
    Shown shown,
    @Nullable String mcap,
    SocketOptions socket,
    AccessOptions access,
    @Nullable String record,
    int maxConnections,
    long maxOutput,
    String budget,
    boolean strict,
    String text,
    Input input,
    List<String> arguments,
    String program) {
  static final int NO_PORT = -1;

  /** The port of the studio, unless another one is given. */
  static final int STUDIO_PORT = 54080;

  /** What the console reads after the code in the options. */
  enum Input {
    /** Nothing. */
    NONE,
    /** The standard input, as the rest of a program. */
    STREAM,
    /** The standard input, as a session: by a user who may interrupt it. */
    SESSION
  }

  boolean hasStudio() {
    return studio != NO_PORT;
  }

  boolean hasPort() {
    return port != NO_PORT;
  }

  /**
   * Whether a simulated time waits for the end of the input, so that the run depends on the input
   * alone and not on when it arrives; somebody at a terminal wants to see it pass.
   */
  boolean holdsTime() {
    return !keepsServing() && input != Input.SESSION;
  }

  /** Whether something may still happen once the console's lobby has nothing to do. */
  boolean keepsServing() {
    return hasPort() || socket.file() != null || hasStudio();
  }
}
