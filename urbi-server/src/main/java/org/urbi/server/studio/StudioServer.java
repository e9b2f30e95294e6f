package org.urbi.server.studio;

import io.netty.bootstrap.ServerBootstrap;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelInitializer;
import io.netty.channel.ChannelOption;
import io.netty.channel.EventLoopGroup;
import io.netty.channel.MultiThreadIoEventLoopGroup;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.channel.group.ChannelGroup;
import io.netty.channel.group.DefaultChannelGroup;
import io.netty.channel.nio.NioIoHandler;
import io.netty.channel.socket.SocketChannel;
import io.netty.channel.socket.nio.NioServerSocketChannel;
import io.netty.handler.codec.http.HttpObjectAggregator;
import io.netty.handler.codec.http.HttpServerCodec;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolConfig;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler;
import io.netty.handler.ssl.SslContext;
import io.netty.util.concurrent.DefaultThreadFactory;
import io.netty.util.concurrent.GlobalEventExecutor;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.time.SystemClock;
import org.urbi.server.Trace;
import org.urbi.server.net.TlsGate;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.TokenThrottle;

/**
 * Serves the studio to browsers, with one thread for all. A slow browser is told less often; none
 * delays the kernel.
 */
public final class StudioServer implements AutoCloseable {
  /** What of a browser has not been sent yet, in bytes: beyond it, nothing more is asked for it. */
  private static final WriteBufferWaterMark BACKLOG = new WriteBufferWaterMark(1 << 18, 1 << 20);

  private static final int MAX_CONNECTIONS = 64;
  private static final int MAX_REQUEST = 1 << 13;
  private static final int HANDSHAKE_MILLISECONDS = 5000;
  private static final int CLOSE_SECONDS = 2;

  private final InetSocketAddress address;
  private final AccessPolicy accessPolicy;
  private final Function<Client, Connection> lobbies;
  private final Trace trace;
  private final TokenThrottle wrong = new TokenThrottle(new SystemClock());
  private final ChannelGroup connections = new DefaultChannelGroup(GlobalEventExecutor.INSTANCE);
  private final EventLoopGroup thread;
  private final InetSocketAddress bound;

  /**
   * Begins to serve.
   *
   * @param address where; port 0 is any that is free
   * @param lobbies makes the lobby of a browser that has been let in
   * @param accessPolicy who is let in, and as what
   * @throws IOException if it cannot listen there, or TLS cannot be had; the message says why
   */
  public StudioServer(
      InetSocketAddress address,
      Function<Client, Connection> lobbies,
      AccessPolicy accessPolicy,
      Trace trace)
      throws IOException {
    this.address = address;
    this.lobbies = lobbies;
    this.accessPolicy = accessPolicy;
    this.trace = trace;
    SslContext tls =
        accessPolicy.identity() == null ? null : TlsGate.context(accessPolicy.identity());
    thread =
        new MultiThreadIoEventLoopGroup(
            1, new DefaultThreadFactory("urbi-studio", true), NioIoHandler.newFactory());
    ChannelFuture opened =
        new ServerBootstrap()
            .group(thread)
            .channel(NioServerSocketChannel.class)
            .option(ChannelOption.SO_REUSEADDR, true)
            .childOption(ChannelOption.TCP_NODELAY, true)
            .childOption(ChannelOption.WRITE_BUFFER_WATER_MARK, BACKLOG)
            .childHandler(
                new ChannelInitializer<SocketChannel>() {
                  @Override
                  protected void initChannel(SocketChannel channel) {
                    if (connections.size() >= MAX_CONNECTIONS) {
                      channel.close();
                    } else {
                      connections.add(channel);
                      handle(channel, tls);
                    }
                  }
                })
            .bind(address)
            .awaitUninterruptibly();
    if (!opened.isSuccess()) {
      thread.shutdownGracefully(0, 1, TimeUnit.SECONDS);
      throw new IOException(
          "cannot serve the studio on "
              + address.getHostString()
              + ":"
              + address.getPort()
              + ": "
              + opened.cause().getMessage(),
          opened.cause());
    }
    connections.add(opened.channel());
    bound = (InetSocketAddress) opened.channel().localAddress();
  }

  private void handle(Channel channel, @Nullable SslContext tls) {
    WebSocketServerProtocolConfig stream =
        WebSocketServerProtocolConfig.newBuilder()
            .websocketPath(StudioFiles.STREAM)
            .checkStartsWith(true)
            .maxFramePayloadLength(Request.LONGEST)
            .handshakeTimeoutMillis(HANDSHAKE_MILLISECONDS)
            .dropPongFrames(false)
            .build();
    if (tls != null) {
      channel.pipeline().addLast(tls.newHandler(channel.alloc()));
    }
    channel
        .pipeline()
        .addLast(
            new Silence(),
            new HttpServerCodec(),
            new HttpObjectAggregator(MAX_REQUEST),
            new StudioFiles(address.getAddress().isLoopbackAddress(), tls != null),
            new WebSocketServerProtocolHandler(stream),
            new Viewer(accessPolicy, wrong, lobbies, trace));
  }

  /** The port on which it listens. */
  public int port() {
    return bound.getPort();
  }

  /**
   * What to give to a browser; a token is still to be put behind {@code ?token=}, if one is asked
   * for.
   */
  public String url() {
    InetAddress where = bound.getAddress();
    String host = address.getHostString();
    String name =
        where.isLoopbackAddress() || where.isAnyLocalAddress()
            ? "localhost"
            : host.contains(":") ? "[" + host + "]" : host;
    String scheme = accessPolicy.identity() == null ? "http" : "https";
    String token = accessPolicy.defaultRole() == null ? "?token=TOKEN" : "";
    return scheme + "://" + name + ":" + port() + "/" + token;
  }

  /** Leaves all browsers alone, and frees the port. */
  @Override
  public void close() {
    connections.close().awaitUninterruptibly(CLOSE_SECONDS, TimeUnit.SECONDS);
    thread
        .shutdownGracefully(0, 1, TimeUnit.SECONDS)
        .awaitUninterruptibly(CLOSE_SECONDS, TimeUnit.SECONDS);
  }
}
