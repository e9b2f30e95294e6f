package org.urbi.bench.soak;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.concurrent.ThreadLocalRandom;

/** One connection of a client, from start to end. */
final class SoakConnection implements AutoCloseable {
  /**
   * More than the time for which anybody can hold the kernel: 5 s of work, 100 s where the machine
   * is so busy that it gets no processor.
   */
  private static final int ANSWER_MILLISECONDS = 120_000;

  private final Socket socket;
  private final InputStream input;
  private final OutputStream output;
  private long received;

  SoakConnection(int port) throws IOException {
    socket = new Socket(InetAddress.getLoopbackAddress(), port);
    socket.setSoTimeout(ANSWER_MILLISECONDS);
    socket.setTcpNoDelay(true);
    input = socket.getInputStream();
    output = socket.getOutputStream();
  }

  void send(String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    output.write(bytes);
  }

  /** Sends a text in pieces with pauses between them. */
  void type(String text, Random random) throws IOException {
    int at = 0;
    while (at < text.length()) {
      int end = Math.min(text.length(), at + 1 + random.nextInt(8));
      send(text.substring(at, end));
      at = end;
      Soak.pause(random.nextInt(5));
    }
  }

  /** Reads up to and with a line that ends so, and returns it. */
  String expect(String end) throws IOException {
    String last = "";
    StringBuilder line = new StringBuilder();
    while (true) {
      int c = input.read();
      if (c < 0) {
        throw new IOException("hung up instead of " + end + ", last line: " + last);
      }
      received++;
      if (c == '\n') {
        last = line.toString();
        if (last.endsWith(end)) {
          return last;
        }
        line.setLength(0);
      } else {
        line.append((char) c);
      }
    }
  }

  /** Asks something that only a lobby which is well answers. */
  void check() throws IOException {
    String word = "word" + ThreadLocalRandom.current().nextInt(1_000_000);
    send("\"" + word + "\";\n");
    expect(" \"" + word + "\"");
  }

  /** The value of an expression, a whole number. */
  int askNumber(String expression) throws IOException {
    send("\"is \" + (" + expression + ") + \" indeed\";\n");
    String answer = expect(" indeed\"");
    return Integer.parseInt(answer.replaceAll(".*\"is (\\d+) indeed\"", "$1"));
  }

  /** Sends no more, and reads to the end. */
  void endInput() throws IOException {
    socket.shutdownOutput();
    byte[] chunk = new byte[8192];
    for (int n = input.read(chunk); n >= 0; n = input.read(chunk)) {
      received += n;
    }
  }

  /** Takes some of what is there, and waits for nothing. */
  void glance() throws IOException {
    int available = input.available();
    if (available > 0) {
      received += input.skip(available);
    }
  }

  /** Is gone without a word: the server gets a reset. */
  void vanish() throws IOException {
    socket.setSoLinger(true, 0);
  }

  long received() {
    return received;
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
