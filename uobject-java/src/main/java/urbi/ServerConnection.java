package urbi;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;

/**
 * An open connection to a server, whatever it is made of: TCP, a Unix domain socket, or TLS where
 * the process is told so. The server has been shown the process's token (docs/networking.md).
 */
public final class ServerConnection implements AutoCloseable {
  /** The system property that asks for TLS; the variable of the environment is URBI_TLS. */
  public static final String TLS_PROPERTY = "urbi.tls";

  /**
   * The system property with the file of the certificates that are trusted, which asks for TLS as
   * well; the variable of the environment is URBI_TLS_CA.
   */
  public static final String TLS_CA_PROPERTY = "urbi.tls.ca";

  private final Socket socket;
  private final InputStream in;
  private final OutputStream out;

  private ServerConnection(Socket socket) throws IOException {
    this.socket = socket;
    in = socket.getInputStream();
    out = socket.getOutputStream();
  }

  /**
   * Connects.
   *
   * @param host a name or an address; one with a {@code /} is the file of a Unix domain socket, for
   *     which there is neither a port nor TLS
   * @param milliseconds how long that may take; 0 for as long as it likes
   * @throws IOException if nobody answers, or somebody whom TLS does not trust; the message says
   *     what to do
   */
  public static ServerConnection open(String host, int port, int milliseconds) throws IOException {
    Socket socket =
        isFile(host) ? UnixSocket.connect(host, milliseconds) : openPort(host, port, milliseconds);
    try {
      ServerConnection connection = new ServerConnection(socket);
      connection.out.write(TokenLine.bytes());
      return connection;
    } catch (IOException e) {
      socket.close();
      throw e;
    }
  }

  private static Socket openPort(String host, int port, int milliseconds) throws IOException {
    Socket plain = new Socket();
    try {
      plain.setTcpNoDelay(true);
      plain.setKeepAlive(true);
      plain.connect(new InetSocketAddress(host, port), milliseconds);
      return TlsClient.isWanted() ? TlsClient.secure(plain, host, port, milliseconds) : plain;
    } catch (IOException e) {
      plain.close();
      throw e;
    }
  }

  /** Whether a host is the file of a Unix domain socket. */
  public static boolean isFile(String host) {
    return host.indexOf('/') >= 0;
  }

  /** The address of a server, for people. */
  public static String name(String host, int port) {
    return isFile(host) ? host : host + ":" + port;
  }

  /** From now on this process connects by TLS, and trusts the certificates in a file alone. */
  public static void trust(String file) {
    System.setProperty(TLS_PROPERTY, "1");
    System.setProperty(TLS_CA_PROPERTY, file);
  }

  /** What the server sends. */
  public InputStream in() {
    return in;
  }

  /** What it is sent. */
  public OutputStream out() {
    return out;
  }

  /** The machine where the server is. */
  public InetAddress address() {
    return socket.getInetAddress();
  }

  /**
   * Has reading give up, by a {@link java.net.SocketTimeoutException}, when nothing has come.
   *
   * @param milliseconds 0 for never, as at first
   */
  public void setReadTimeout(int milliseconds) throws IOException {
    socket.setSoTimeout(milliseconds);
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
