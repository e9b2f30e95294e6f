package org.urbi.server.net;

import static java.util.Objects.requireNonNull;

import io.netty.bootstrap.ServerBootstrap;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInitializer;
import io.netty.channel.ChannelOption;
import io.netty.channel.ChannelPipeline;
import io.netty.channel.EventLoopGroup;
import io.netty.channel.group.ChannelGroup;
import io.netty.channel.group.DefaultChannelGroup;
import io.netty.handler.ssl.SslContext;
import io.netty.util.concurrent.GlobalEventExecutor;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.remote.RemotePeer;
import org.urbi.kernel.remote.RemoteTransport;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;
import org.urbi.server.Trace;
import org.urbi.server.Version;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.TokenThrottle;
import org.urbi.web.NetworkLoop;

/**
 * Listens for telnet-like clients and gives each its lobby (options {@code --host}, {@code --port}
 * and {@code --socket}; manual, section 21.3).
 */
public final class ConsoleServer implements AutoCloseable {
  /**
   * Clients beyond this number wait a second until their next attempt. The system may have a lower
   * limit.
   */
  private static final int PENDING_CONNECTIONS = 4096;

  private static final int CLOSE_SECONDS = 1;

  private final Clock clock = new SystemClock();
  private final EventLoopGroup loop;
  private final ChannelGroup clients = new DefaultChannelGroup(GlobalEventExecutor.INSTANCE);
  private final ChannelGroup listeners = new DefaultChannelGroup(GlobalEventExecutor.INSTANCE);
  private final DatagramPort datagrams;
  private final Function<Client, Connection> lobbies;
  private final @Nullable BiFunction<String, RemoteTransport, RemotePeer> remotes;
  private final Limits limits;
  private final AccessPolicy accessPolicy;
  private final Trace trace;
  private final TokenThrottle wrong = new TokenThrottle(new SystemClock());
  private final TotalOutput totalOutput;
  private final ConnectionLimit crowd;
  private @Nullable InetSocketAddress address;
  private @Nullable UnixSocketFile socket;
  private volatile boolean answered = true;
  private long asked;

  /**
   * Starts listening.
   *
   * @param address where; port 0 takes any free one, see {@link #port}
   * @param lobbies makes the lobby of a new client, and may welcome it; called on the network
   *     thread
   * @throws IOException if the address cannot be listened to; the message says which and why
   */
  public ConsoleServer(
      InetSocketAddress address, Function<Client, Connection> lobbies, Limits limits, Trace trace)
      throws IOException {
    this(address, lobbies, null, limits, AccessPolicy.ALL, trace);
  }

  /**
   * Starts listening, for processes with UObjects, too; everybody is let in.
   *
   * @throws IOException if the address cannot be listened to; the message says which and why
   */
  public ConsoleServer(
      InetSocketAddress address,
      Function<Client, Connection> lobbies,
      BiFunction<String, RemoteTransport, RemotePeer> remotes,
      Limits limits,
      Trace trace)
      throws IOException {
    this(address, lobbies, remotes, limits, AccessPolicy.ALL, trace);
  }

  /**
   * Starts listening, for processes with UObjects, too.
   *
   * @param address where; port 0 takes any free one, see {@link #port}
   * @throws IOException if the address cannot be listened to, or TLS cannot be had; the message
   *     says which and why
   */
  public ConsoleServer(
      InetSocketAddress address,
      Function<Client, Connection> lobbies,
      @Nullable BiFunction<String, RemoteTransport, RemotePeer> remotes,
      Limits limits,
      AccessPolicy accessPolicy,
      Trace trace)
      throws IOException {
    this(lobbies, remotes, limits, accessPolicy, trace);
    try {
      listen(address);
    } catch (IOException e) {
      close();
      throw e;
    }
  }

  /**
   * Listens nowhere yet.
   *
   * @param lobbies makes the lobby of a new client, and may welcome it; called on the network
   *     thread
   * @param remotes makes the kernel's side of a process with UObjects, given its name for people
   *     and the way to it; null if there are to be none
   * @param accessPolicy who is let in, and as what
   */
  public ConsoleServer(
      Function<Client, Connection> lobbies,
      @Nullable BiFunction<String, RemoteTransport, RemotePeer> remotes,
      Limits limits,
      AccessPolicy accessPolicy,
      Trace trace) {
    this.lobbies = lobbies;
    this.remotes = remotes;
    this.limits = limits;
    this.accessPolicy = accessPolicy;
    this.trace = trace;
    loop = NetworkLoop.group("urbi-network", FailureLog::internal);
    datagrams = new DatagramPort(loop, this::datagramAddress, trace);
    totalOutput = new TotalOutput(limits.totalOutput());
    crowd = new ConnectionLimit(clients, limits.connections(), trace);
  }

  /**
   * Listens on a port, once.
   *
   * @param where port 0 takes any free one, see {@link #port}
   * @throws IOException if the address cannot be listened to, or TLS cannot be had; the message
   *     says which and why
   */
  public void listen(InetSocketAddress where) throws IOException {
    SslContext tls =
        accessPolicy.identity() == null ? null : TlsGate.context(accessPolicy.identity());
    ChannelFuture bound =
        bootstrap(tls)
            .channelFactory(ConsoleListener::new)
            .handler(new AcceptFailures(trace))
            .option(ChannelOption.SO_REUSEADDR, true)
            .option(ChannelOption.SO_BACKLOG, PENDING_CONNECTIONS)
            .childOption(ChannelOption.ALLOW_HALF_CLOSURE, true)
            .childOption(ChannelOption.SO_KEEPALIVE, true)
            .childOption(ChannelOption.TCP_NODELAY, true)
            .bind(where)
            .awaitUninterruptibly();
    if (!bound.isSuccess()) {
      throw new IOException(
          "cannot listen on "
              + where.getHostString()
              + ":"
              + where.getPort()
              + ": "
              + bound.cause().getMessage(),
          bound.cause());
    }
    listeners.add(bound.channel());
    address = (InetSocketAddress) bound.channel().localAddress();
  }

  /**
   * Listens on a Unix domain socket, once. TLS is not spoken there: who may write the file may
   * connect, and nobody else can listen in.
   *
   * @param permissions of the file, which is removed at the end
   * @throws IOException if that is not possible; the message says why
   */
  public void listen(Path file, Set<PosixFilePermission> permissions) throws IOException {
    UnixSocketFile opened = UnixSocketFile.listen(file, permissions, PENDING_CONNECTIONS);
    socket = opened;
    ChannelFuture registered =
        bootstrap(null)
            .channelFactory(() -> new UnixListener(opened.channel()))
            .handler(new AcceptFailures(trace))
            .register()
            .awaitUninterruptibly();
    if (!registered.isSuccess()) {
      throw new IOException(
          "cannot listen on the socket " + file + ": " + registered.cause().getMessage(),
          registered.cause());
    }
    listeners.add(registered.channel());
  }

  private ServerBootstrap bootstrap(@Nullable SslContext tls) {
    return new ServerBootstrap()
        .group(loop)
        .childHandler(
            new ChannelInitializer<>() {
              @Override
              protected void initChannel(Channel client) {
                if (crowd.acceptClient(client)) {
                  handle(client, tls);
                }
              }

              @Override
              public void exceptionCaught(ChannelHandlerContext context, Throwable failure) {
                ConsoleHandler.refuse(context, failure);
              }
            });
  }

  private void handle(Channel client, @Nullable SslContext tls) {
    ChannelPipeline pipeline = client.pipeline();
    if (tls != null) {
      pipeline.addLast(new TlsGate(tls, trace));
    }
    pipeline.addLast(new ForeignProtocolFilter(trace));
    if (accessPolicy.asks()) {
      pipeline.addLast(new TokenAuthenticator(accessPolicy, wrong, trace));
    }
    if (remotes != null) {
      pipeline.addLast(
          new ProtocolDetector(
              () -> new FrameHandler(remotes, datagrams, trace), Version.number()));
    }
    ConsoleHandler console = new ConsoleHandler(lobbies, limits, totalOutput, trace);
    pipeline.addLast(new TelnetDecoder(console::output), console);
  }

  /**
   * How long the network thread has been blocked, in nanoseconds. Called at intervals by one
   * thread.
   */
  public long silence() {
    if (answered) {
      answered = false;
      asked = clock.now();
      NetworkThread.execute(loop.next(), () -> answered = true);
      return 0;
    }
    return clock.now() - asked;
  }

  /** The port that is listened to. */
  public int port() {
    return datagramAddress().getPort();
  }

  private InetSocketAddress datagramAddress() {
    return requireNonNull(address, "no port is listened to");
  }

  /**
   * Stops listening, gives closing clients a moment to read their last output, then closes all
   * connections.
   */
  @Override
  public void close() {
    if (loop.isShuttingDown()) {
      return;
    }
    removeSocketFile();
    listeners.close().awaitUninterruptibly();
    datagrams.close();
    clients.newCloseFuture().awaitUninterruptibly(CLOSE_SECONDS, TimeUnit.SECONDS);
    clients.close().awaitUninterruptibly();
    loop.shutdownGracefully(0, 1, TimeUnit.SECONDS).awaitUninterruptibly();
  }

  private void removeSocketFile() {
    try {
      if (socket != null) {
        socket.close();
      }
    } catch (IOException e) {
      trace.debug("cannot remove the socket " + socket.path() + ": " + e.getMessage());
    }
  }
}
