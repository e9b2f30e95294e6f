package org.urbi.server.net;

import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.trust.Role;
import org.urbi.server.trust.Tokens;

/** A client that comes to a server by one of the ways that there are, and may leave. */
final class Visitor implements AutoCloseable {
  private static final String TOKEN = "owner-0123456789";

  /** What the program telnet says first: it offers its type, its speed, and asks for an echo. */
  private static final String GREETING = "\u00ff\u00fb\u0018\u00ff\u00fb\u0020\u00ff\u00fd\u0001";

  /** The answers to that, and to all else that telnet may ask. */
  private static final String ANSWERS = "\u00ff[\u00fb-\u00fe].";

  /** How a client comes. */
  enum Way {
    TCP(false, false, false, ""),
    TELNET(false, false, false, GREETING),
    TOKEN(false, false, true, ""),
    TLS(false, true, false, ""),
    TLS_AND_TOKEN(false, true, true, ""),
    SOCKET(true, false, false, ""),
    SOCKET_AND_TOKEN(true, false, true, ""),
    SOCKET_AND_TELNET(true, false, false, GREETING);

    final boolean local;
    final boolean tls;
    private final boolean token;
    private final String greeting;

    Way(boolean local, boolean tls, boolean token, String greeting) {
      this.local = local;
      this.tls = tls;
      this.token = token;
      this.greeting = (token ? "//token " + Visitor.TOKEN + "\n" : "") + greeting;
    }

    /** What a server wants to be shown by who comes so. */
    @Nullable Tokens tokens() {
      return token ? Tokens.single(Visitor.TOKEN, Role.OWNER, "a visitor") : null;
    }
  }

  private interface End {
    void run() throws IOException;
  }

  private final Closeable connection;
  private final OutputStream out;
  private final BufferedReader in;
  private final End end;

  private Visitor(Closeable connection, InputStream in, OutputStream out, End end) {
    this.connection = connection;
    this.out = out;
    this.in = new BufferedReader(new InputStreamReader(in, StandardCharsets.ISO_8859_1));
    this.end = end;
  }

  /** Comes to a server, which listens on that port, or on the socket. */
  static Visitor come(Way way, int port, Path socket, TestIdentity identity)
      throws IOException, GeneralSecurityException {
    Visitor visitor = way.local ? local(socket) : remote(way, port, identity);
    visitor.send(way.greeting);
    return visitor;
  }

  private static Visitor local(Path file) throws IOException {
    SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(file));
    return new Visitor(
        channel,
        Channels.newInputStream(channel),
        Channels.newOutputStream(channel),
        channel::shutdownOutput);
  }

  private static Visitor remote(Way way, int port, TestIdentity identity)
      throws IOException, GeneralSecurityException {
    Socket plain = new Socket(InetAddress.getLoopbackAddress(), port);
    Socket socket = way.tls ? identity.secure(plain) : plain;
    return new Visitor(
        socket, socket.getInputStream(), socket.getOutputStream(), socket::shutdownOutput);
  }

  void send(String text) throws IOException {
    out.write(text.getBytes(StandardCharsets.ISO_8859_1));
    out.flush();
  }

  /** The next line without its time stamp, and without words of telnet; null at the end. */
  @Nullable String line() throws IOException {
    String line = in.readLine();
    return line == null
        ? null
        : line.replaceAll(ANSWERS, "").replaceFirst("^\\[\\d+(:?[^]]*)] ", "[$1] ");
  }

  /** Sends a statement and returns the line that answers it. */
  @Nullable String ask(String statement) throws IOException {
    send(statement);
    return line();
  }

  /** The end of what this side has to say. */
  void end() throws IOException {
    end.run();
  }

  /** Leaves, as programs do that end. */
  @Override
  public void close() throws IOException {
    connection.close();
  }
}
