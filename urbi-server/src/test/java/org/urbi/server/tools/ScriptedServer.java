package org.urbi.server.tools;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.UnaryOperator;

/** A server for one client that answers each line by rote; null as an answer hangs up. */
final class ScriptedServer implements AutoCloseable {
  private final ServerSocket listener;
  private final BlockingQueue<String> received = new LinkedBlockingQueue<>();

  ScriptedServer(UnaryOperator<String> answers) throws IOException {
    listener = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    Thread.ofVirtual().start(() -> serve(answers));
  }

  int port() {
    return listener.getLocalPort();
  }

  /** The next line that the client sent; waits for it. */
  String received() throws InterruptedException {
    return received.take();
  }

  private void serve(UnaryOperator<String> answers) {
    try (Socket client = listener.accept()) {
      BufferedReader in =
          new BufferedReader(
              new InputStreamReader(client.getInputStream(), StandardCharsets.ISO_8859_1));
      OutputStream out = client.getOutputStream();
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        received.add(line);
        String answer = answers.apply(line);
        if (answer == null) {
          return;
        }
        out.write(answer.getBytes(StandardCharsets.ISO_8859_1));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    listener.close();
  }
}
