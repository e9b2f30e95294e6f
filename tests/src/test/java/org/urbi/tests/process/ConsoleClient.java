package org.urbi.tests.process;

import java.io.BufferedReader;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.urbi.tests.TestTimeout;

/** A client of the console, as netcat is one. */
final class ConsoleClient implements AutoCloseable {
  private final Socket socket;
  private final BufferedReader in;
  private int marks;

  ConsoleClient(int port) throws IOException {
    socket = new Socket(InetAddress.getLoopbackAddress(), port);
    socket.setTcpNoDelay(true);
    socket.setSoTimeout((int) TestTimeout.LONG.toMillis());
    in = new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
    answers("");
  }

  void send(String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.UTF_8));
    socket.getOutputStream().flush();
  }

  /** The next line; throws if none comes, an {@link EOFException} if none can come any more. */
  String line() throws IOException {
    try {
      String line = in.readLine();
      if (line == null) {
        throw new EOFException("the server has closed the connection");
      }
      return line;
    } catch (SocketTimeoutException e) {
      throw new AssertionError("no answer", e);
    }
  }

  /** Sends a text, and returns the lines that are answered until all of it has been executed. */
  List<String> answers(String text) throws IOException {
    String mark = "mark " + ++marks;
    send(text + "\necho(\"" + mark + "\");\n");
    List<String> lines = new ArrayList<>();
    for (String line = line(); !line.endsWith("] *** " + mark); line = line()) {
      lines.add(line);
    }
    return lines;
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
