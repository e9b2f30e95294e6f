package org.urbi.server.net;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;

/** A client of the network console, as plain as netcat. */
final class TestClient implements AutoCloseable {
  private final Socket socket;
  private final BufferedReader in;

  TestClient(int port) throws IOException {
    socket = new Socket(InetAddress.getLoopbackAddress(), port);
    in =
        new BufferedReader(
            new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
  }

  void send(String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** The next line without its time stamp; null at the end. */
  String line() throws IOException {
    String line = in.readLine();
    return line == null ? null : line.replaceFirst("^\\[\\d+(:?[^]]*)] ", "[$1] ");
  }

  /** Sends a statement and returns the line that answers it. */
  String ask(String statement) throws IOException {
    send(statement);
    return line();
  }

  /** The end of what this side has to say. */
  void end() throws IOException {
    socket.shutdownOutput();
  }

  /** Vanishes without a word: the other side sees a reset. */
  void vanish() throws IOException {
    socket.setSoLinger(true, 0);
    socket.close();
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
