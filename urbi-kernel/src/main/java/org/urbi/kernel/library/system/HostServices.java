package org.urbi.kernel.library.system;

import java.io.IOException;
import java.nio.file.Path;
import org.urbi.kernel.error.Problem;

/**
 * What the program around a kernel does when code asks for it. Called on threads that may wait, and
 * not at all in a replay. A program that cannot do something leaves it as it is here: it fails.
 */
public interface HostServices {
  /** The port for which {@link #openStudio} takes its usual one. */
  int USUAL_PORT = -1;

  /** A program that does nothing of all this. */
  HostServices NONE = new HostServices() {};

  /**
   * Serves the studio, unless it is served already.
   *
   * @param port 0 for any that is free
   * @return its address
   * @throws IOException if it cannot be served; the message says why
   */
  default String openStudio(int port) throws IOException {
    throw new IOException(Problem.NOT_POSSIBLE.text());
  }

  /**
   * Begins to record the variables, the jobs and the log.
   *
   * @param file is created, or overwritten
   * @throws IOException if it cannot be written, or something is being recorded
   */
  default void startMcap(Path file) throws IOException {
    throw new IOException(Problem.NOT_POSSIBLE.text());
  }

  /**
   * Ends the recording of variables: when this returns, the file is complete.
   *
   * @throws IOException if nothing is being recorded
   */
  default void stopMcap() throws IOException {
    throw new IOException(Problem.NOT_POSSIBLE.text());
  }
}
