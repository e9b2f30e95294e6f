package org.urbi.kernel.outside;

import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.UnknownHostException;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Job;

/** Opens connections, and listens for them. */
public final class Network {
  /** The largest number of a port. */
  public static final int MAXIMUM_PORT = 65_535;

  private static final Path SERVICES = Path.of("/etc/services");

  /** As many as most systems allow; Java's own limit is 50, and further clients wait a second. */
  private static final int PENDING_CONNECTIONS = 4096;

  private Network() {}

  /** A connection with its two ends. */
  public record OpenConnection(
      SocketConnection link, InetSocketAddress local, InetSocketAddress remote) {}

  /** A server socket, which accepts connections until it is closed. */
  public record ListeningSocket(InetSocketAddress local, Closeable place) {}

  /**
   * Connects to a host while the job waits.
   *
   * @param port a number, or the name of a service
   * @throws IOException when it cannot be reached; the message says why
   */
  public static OpenConnection connect(Outside outside, Job job, String host, String port)
      throws IOException {
    outside.confinement().checkConnections();
    SocketChannel channel = outside.awaitOpen(job, () -> SocketChannel.open(address(host, port)));
    return connected(outside, channel);
  }

  private static OpenConnection connected(Outside outside, @Nullable SocketChannel channel)
      throws IOException {
    return new OpenConnection(
        link(outside, channel),
        outside.query(() -> internet(Outside.live(channel).getLocalAddress())),
        outside.query(() -> internet(Outside.live(channel).getRemoteAddress())));
  }

  /**
   * @param channel null in a replay
   */
  static SocketConnection link(Outside outside, @Nullable SocketChannel channel)
      throws IOException {
    if (channel == null) {
      return SocketConnection.replayed(outside, true);
    }
    channel.socket().setTcpNoDelay(true);
    return new SocketConnection(
        outside,
        new GatheringStream(channel.socket()),
        channel.socket().getOutputStream(),
        channel,
        true);
  }

  static InetSocketAddress internet(SocketAddress address) {
    return (InetSocketAddress) address;
  }

  /**
   * Listens for connections.
   *
   * @param port a number, 0 for any that is free, or the name of a service
   * @param listener called for each connection, on the kernel thread
   * @throws IOException when it is not possible; the message says why
   */
  public static ListeningSocket listen(
      Outside outside, Job job, String host, String port, Consumer<OpenConnection> listener)
      throws IOException {
    outside.confinement().checkConnections();
    ServerSocketChannel place =
        outside.awaitOpen(
            job,
            () -> {
              ServerSocketChannel made = ServerSocketChannel.open();
              try {
                return made.bind(address(host, port), PENDING_CONNECTIONS);
              } catch (IOException | RuntimeException e) {
                made.close();
                throw e;
              }
            });
    outside.scheduler().pace().begin();
    IncomingConnections arrivals = new IncomingConnections(outside, listener);
    if (place != null) {
      outside.opened(place);
      outside.startVirtual(() -> arrivals.accept(place));
    }
    return new ListeningSocket(
        outside.query(() -> internet(Outside.live(place).getLocalAddress())),
        place == null ? () -> {} : place);
  }

  private static InetSocketAddress address(String host, String port) throws IOException {
    InetAddress address;
    try {
      address = InetAddress.getByName(host);
    } catch (UnknownHostException e) {
      throw new IOException(Problem.UNKNOWN_HOST.text(host), e);
    }
    return new InetSocketAddress(address, port(port));
  }

  private static int port(String name) throws IOException {
    if (name.matches("-?[0-9]+")) {
      int port = name.length() > 5 ? MAXIMUM_PORT + 1 : Integer.parseInt(name);
      if (port < 0 || port > MAXIMUM_PORT) {
        throw new IOException(Problem.INVALID_PORT.text(name));
      }
      return port;
    }
    return service(name);
  }

  /** The port of a service that the machine knows by name. */
  private static int service(String name) throws IOException {
    try (BufferedReader lines = Files.newBufferedReader(SERVICES, StandardCharsets.ISO_8859_1)) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        String[] words = line.replaceFirst("#.*", "").trim().split("\\s+");
        for (int i = 0; i < words.length && words.length > 1; i++) {
          if (i != 1 && words[i].equals(name) && words[1].endsWith("/tcp")) {
            return Integer.parseInt(words[1].substring(0, words[1].indexOf('/')));
          }
        }
      }
    } catch (NoSuchFileException e) {
      // The machine has no table of services.
    }
    throw new IOException(Problem.UNKNOWN_SERVICE.text(name));
  }

  /**
   * The name of this machine, which takes a moment.
   *
   * @throws IOException when it has none
   */
  public static String localHostName(Outside outside, Job job) throws IOException {
    outside.confinement().checkConnections();
    return outside.await(job, () -> InetAddress.getLocalHost().getHostName());
  }

  /**
   * Opens a serial line while the job waits.
   *
   * @throws IOException when it cannot be opened or has no such speed; the message says why
   */
  public static SocketConnection serial(Outside outside, Job job, Path device, int baudRate)
      throws IOException {
    outside.confinement().checkConnections();
    SerialLine line =
        outside.awaitOpen(
            job,
            () -> {
              // The line must be in raw mode before the first byte arrives; and whoever opens one
              // that looks at the signals of a modem would wait until there is one.
              Process stty =
                  new ProcessBuilder(
                          "stty",
                          "-F",
                          device.toString(),
                          "raw",
                          "-echo",
                          "clocal",
                          Integer.toString(baudRate))
                      .redirectErrorStream(true)
                      .start();
              stty.getOutputStream().close();
              String message =
                  new String(stty.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
              try {
                if (stty.waitFor() != 0) {
                  throw new IOException(message.strip());
                }
              } catch (InterruptedException e) {
                throw new IOException(e);
              }
              return SerialLine.open(device);
            });
    return line == null
        ? SocketConnection.replayed(outside, false)
        : new SocketConnection(
            outside,
            Channels.newInputStream(line.in),
            Channels.newOutputStream(line.out),
            line,
            false);
  }

  /**
   * Both directions of a line, each by a channel of its own: one of them may be waited for, and
   * only channels let those go who wait when they are closed.
   */
  private record SerialLine(FileChannel in, FileChannel out) implements Closeable {
    static SerialLine open(Path device) throws IOException {
      FileChannel in = FileChannel.open(device, StandardOpenOption.READ);
      try {
        return new SerialLine(in, FileChannel.open(device, StandardOpenOption.WRITE));
      } catch (IOException | RuntimeException e) {
        in.close();
        throw e;
      }
    }

    @Override
    public void close() throws IOException {
      out.close();
      in.close();
    }
  }
}
