package org.urbi.ros.one;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.urbi.ros.graph.Failures;
import org.urbi.ros.net.AcceptLoop;
import urbi.Log;

/** Answers calls of the master and of other nodes: as much of HTTP as XML-RPC needs. */
final class XmlRpcServer implements AutoCloseable {
  private static final int MAX_BODY = 1 << 20;
  private static final int MAX_LINE = 8192;
  private static final int MAX_LINES = 100;
  private static final int MAX_CONNECTIONS = 256;

  /** Milliseconds: who says nothing for so long is let go. */
  private static final int SILENCE = 30_000;

  /** After somebody could not be served. */
  private static final Duration PAUSE = Duration.ofSeconds(1);

  /** What answers. */
  interface Handler {
    /**
     * The answer: a code, a status, a value.
     *
     * @throws RuntimeException a fault
     */
    List<?> call(String method, List<Object> arguments);
  }

  private final ServerSocket socket;
  private final Handler handler;
  private final Set<Socket> clients = ConcurrentHashMap.newKeySet();

  XmlRpcServer(InetAddress address, Handler handler) throws IOException {
    this.handler = handler;
    socket = new ServerSocket(0, 50, address);
    AcceptLoop loop = new AcceptLoop("urbi-ros-call", socket, new Callers(), Log::error, PAUSE);
    Threads.start("calls", loop::run);
  }

  int port() {
    return socket.getLocalPort();
  }

  private final class Callers implements AcceptLoop.Clients {
    @Override
    public boolean arrives(Socket client) {
      return clients.size() < MAX_CONNECTIONS && clients.add(client);
    }

    @Override
    public void serve(Socket client) throws IOException {
      serveCaller(client);
    }

    @Override
    public void leaves(Socket client) {
      clients.remove(client);
    }
  }

  private void serveCaller(Socket client) throws IOException {
    client.setSoTimeout(SILENCE);
    InputStream in = new BufferedInputStream(client.getInputStream());
    OutputStream out = client.getOutputStream();
    boolean more = true;
    while (more) {
      String request = line(in);
      int length = -1;
      more = request.endsWith("HTTP/1.1");
      boolean ended = false;
      for (int i = 0; i < MAX_LINES && !ended; i++) {
        String header = line(in).toLowerCase(Locale.ROOT);
        ended = header.isEmpty();
        if (header.startsWith("content-length:")) {
          length = length(header.substring("content-length:".length()));
        } else if (header.startsWith("connection:")) {
          more = header.contains("keep-alive") || more && !header.contains("close");
        }
      }
      if (!request.startsWith("POST ") || !ended || length < 0 || length > MAX_BODY) {
        send(out, "400 Bad Request", "", false);
        return;
      }
      byte[] body = in.readNBytes(length);
      if (body.length < length) {
        throw new EOFException();
      }
      send(out, "200 OK", answer(body), more);
    }
  }

  private static int length(String text) {
    try {
      return Integer.parseInt(text.strip());
    } catch (NumberFormatException e) {
      return -1;
    }
  }

  private String answer(byte[] body) {
    try {
      XmlRpcReader.Call call = XmlRpcReader.call(body);
      return XmlRpcWriter.response(handler.call(call.method(), call.arguments()));
    } catch (XmlRpcException e) {
      return XmlRpcWriter.fault(String.valueOf(e.getMessage()));
    } catch (RuntimeException | Error e) {
      return XmlRpcWriter.fault(Failures.told("a call of a master or a node", e));
    }
  }

  private static void send(OutputStream out, String status, String body, boolean more)
      throws IOException {
    byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
    String head =
        "HTTP/1.1 "
            + status
            + "\r\nServer: urbi\r\nContent-Type: text/xml\r\nContent-Length: "
            + bytes.length
            + "\r\nConnection: "
            + (more ? "keep-alive" : "close")
            + "\r\n\r\n";
    byte[] whole = (head + body).getBytes(StandardCharsets.UTF_8);
    out.write(whole);
    out.flush();
  }

  private static String line(InputStream in) throws IOException {
    StringBuilder line = new StringBuilder();
    for (int c = in.read(); c != '\n'; c = in.read()) {
      if (c < 0 || line.length() > MAX_LINE) {
        throw new EOFException();
      }
      line.append((char) c);
    }
    return line.toString().stripTrailing();
  }

  @Override
  public void close() throws IOException {
    socket.close();
    for (Socket client : clients) {
      client.close();
    }
  }
}
