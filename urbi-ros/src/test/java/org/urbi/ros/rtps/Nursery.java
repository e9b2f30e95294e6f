package org.urbi.ros.rtps;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.Writer;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Collectors;
import org.urbi.ros.Awaited;
import org.urbi.ros.Lines;

/**
 * A process that has imported ROS 2, and forks peers: they need not import it, each for itself.
 * There is one for an environment of Python, as long as the tests run.
 */
final class Nursery {
  private static final Map<String, Nursery> STARTED = new HashMap<>();

  private final Lines answers;
  private final Writer wishes;

  /** A peer that runs. What it says ends with the process. */
  record Child(ProcessHandle process, Socket connection) {
    InputStream output() throws IOException {
      return connection.getInputStream();
    }

    /** What it reads. Whoever closes that still hears it. */
    OutputStream input() throws IOException {
      return new FilterOutputStream(connection.getOutputStream()) {
        @Override
        public void write(byte[] bytes, int start, int length) throws IOException {
          out.write(bytes, start, length);
        }

        @Override
        public void close() {
          try {
            connection.shutdownOutput();
          } catch (IOException e) {
            // It has ended.
          }
        }
      };
    }
  }

  private Nursery(Path python, Path script) throws IOException {
    ProcessBuilder builder = new ProcessBuilder(python.toString(), script.toString());
    // Threads would not survive the fork.
    builder.environment().put("OPENBLAS_NUM_THREADS", "1");
    Process process = builder.redirectError(ProcessBuilder.Redirect.INHERIT).start();
    answers = new Lines(process.inputReader());
    wishes = process.outputWriter();
  }

  /** The one for that Python; starts it when it is the first time. */
  static Nursery of(Path python, Path script) throws IOException {
    synchronized (STARTED) {
      Nursery nursery = STARTED.get(python.toString());
      if (nursery == null) {
        nursery = new Nursery(python, script);
        STARTED.put(python.toString(), nursery);
      }
      return nursery;
    }
  }

  /**
   * Starts a peer.
   *
   * @param environment what it has besides that of the tests
   */
  synchronized Child fork(Path script, Map<String, String> environment) throws IOException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.ofLiteral("127.0.0.1"))) {
      server.setSoTimeout(Awaited.MILLISECONDS);
      String settings =
          environment.entrySet().stream()
              .map(each -> quoted(each.getKey()) + ":" + quoted(each.getValue()))
              .collect(Collectors.joining(",", "{", "}"));
      wishes.write(
          "{\"port\":%d,\"script\":%s,\"environment\":%s}\n"
              .formatted(server.getLocalPort(), quoted(script.toString()), settings));
      wishes.flush();
      ProcessHandle process = ProcessHandle.of(number()).orElseThrow();
      Socket connection = server.accept();
      connection.setTcpNoDelay(true);
      return new Child(process, connection);
    }
  }

  private long number() {
    try {
      return Long.parseLong(answers.next());
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private static String quoted(String text) {
    return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }
}
