package org.urbi.server.net;

import io.netty.bootstrap.ServerBootstrap;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInitializer;
import io.netty.channel.ChannelOption;
import io.netty.channel.EventLoopGroup;
import io.netty.channel.MultiThreadIoEventLoopGroup;
import io.netty.channel.group.ChannelGroup;
import io.netty.channel.group.DefaultChannelGroup;
import io.netty.channel.nio.NioIoHandler;
import io.netty.handler.ssl.SslContext;
import io.netty.util.concurrent.DefaultThreadFactory;
import io.netty.util.concurrent.GlobalEventExecutor;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.concurrent.TimeUnit;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.remote.RemotePeer;
import org.urbi.kernel.remote.RemoteTransport;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;
import org.urbi.server.Trace;
import org.urbi.server.Version;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.TokenThrottle;

/**
 * Listens for telnet-like clients and gives each its lobby (options {@code --host} and {@code
 * --port}; manual, section 21.3).
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
  private final Channel listener;
  private final DatagramPort datagrams;
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
   * @param lobbies makes the lobby of a new client, and may welcome it; called on the network
   *     thread
   * @param remotes makes the kernel's side of a process with UObjects, given its name for people
   *     and the way to it; null if there are to be none
   * @param accessPolicy who is let in, and as what
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
    SslContext tls =
        accessPolicy.identity() == null ? null : TlsGate.context(accessPolicy.identity());
    loop =
        new MultiThreadIoEventLoopGroup(
            1, new DefaultThreadFactory("urbi-network", true), NioIoHandler.newFactory());
    datagrams =
        new DatagramPort(loop, () -> new InetSocketAddress(address.getAddress(), port()), trace);
    TokenThrottle wrong = new TokenThrottle(new SystemClock());
    TotalOutput totalOutput = new TotalOutput(limits.totalOutput());
    ConnectionLimit crowd = new ConnectionLimit(clients, limits.connections(), trace);
    ChannelFuture bound =
        new ServerBootstrap()
            .group(loop)
            .channelFactory(() -> new ConsoleListener(trace))
            .option(ChannelOption.SO_REUSEADDR, true)
            .option(ChannelOption.SO_BACKLOG, PENDING_CONNECTIONS)
            .childOption(ChannelOption.SO_KEEPALIVE, true)
            .childOption(ChannelOption.TCP_NODELAY, true)
            .childOption(ChannelOption.ALLOW_HALF_CLOSURE, true)
            .childHandler(
                new ChannelInitializer<>() {
                  @Override
                  protected void initChannel(Channel client) {
                    if (!crowd.acceptClient(client)) {
                      return;
                    }
                    if (tls != null) {
                      client.pipeline().addLast(new TlsGate(tls, trace));
                    }
                    client.pipeline().addLast(new ForeignProtocolFilter(trace));
                    if (accessPolicy.asks()) {
                      client.pipeline().addLast(new TokenAuthenticator(accessPolicy, wrong, trace));
                    }
                    if (remotes != null) {
                      client
                          .pipeline()
                          .addLast(
                              new ProtocolDetector(
                                  () -> new FrameHandler(remotes, datagrams, trace),
                                  Version.number()));
                    }
                    client
                        .pipeline()
                        .addLast(
                            new TelnetDecoder(),
                            new ConsoleHandler(lobbies, limits, totalOutput, trace));
                  }

                  @Override
                  public void exceptionCaught(ChannelHandlerContext context, Throwable failure) {
                    ConsoleHandler.refuse(context, failure);
                  }
                })
            .bind(address)
            .awaitUninterruptibly();
    if (!bound.isSuccess()) {
      loop.shutdownGracefully(0, 0, TimeUnit.SECONDS);
      throw new IOException(
          "cannot listen on "
              + address.getHostString()
              + ":"
              + address.getPort()
              + ": "
              + bound.cause().getMessage(),
          bound.cause());
    }
    listener = bound.channel();
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
    return ((InetSocketAddress) listener.localAddress()).getPort();
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
    listener.close().awaitUninterruptibly();
    datagrams.close();
    clients.newCloseFuture().awaitUninterruptibly(CLOSE_SECONDS, TimeUnit.SECONDS);
    clients.close().awaitUninterruptibly();
    loop.shutdownGracefully(0, 1, TimeUnit.SECONDS).awaitUninterruptibly();
  }
}
