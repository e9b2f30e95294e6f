package org.urbi.sim.page;

import io.netty.bootstrap.ServerBootstrap;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelInitializer;
import io.netty.channel.ChannelOption;
import io.netty.channel.EventLoopGroup;
import io.netty.channel.MultiThreadIoEventLoopGroup;
import io.netty.channel.WriteBufferWaterMark;
import io.netty.channel.nio.NioIoHandler;
import io.netty.channel.socket.SocketChannel;
import io.netty.channel.socket.nio.NioServerSocketChannel;
import io.netty.handler.codec.http.HttpObjectAggregator;
import io.netty.handler.codec.http.HttpServerCodec;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolConfig;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler;
import io.netty.handler.timeout.IdleStateHandler;
import io.netty.util.concurrent.DefaultThreadFactory;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.concurrent.TimeUnit;
import org.urbi.sim.SimulationException;

/**
 * Serves the page of a world and its stream of snapshots, with one thread for all browsers. A slow
 * browser gets fewer snapshots; no browser delays the simulation.
 */
public final class PageServer implements AutoCloseable {
  /** What of a browser has not been sent yet, in bytes: beyond it, moments are left out. */
  private static final WriteBufferWaterMark BACKLOG = new WriteBufferWaterMark(1 << 16, 1 << 18);

  private static final int MAX_REQUEST = 1 << 13;
  private static final int MAX_MESSAGE = 1 << 10;
  private static final int HANDSHAKE_MILLISECONDS = 5000;
  private static final int IDLE_SECONDS = 20;
  private static final int CLOSE_SECONDS = 2;
  private static final int MAX_PORT = 65_535;

  private final String host;
  private final EventLoopGroup thread;
  private final Viewers viewers;
  private final Channel listening;
  private final InetSocketAddress bound;

  /**
   * Begins to serve.
   *
   * @param host the address to listen on: {@code localhost} for this machine alone
   * @param port 0 for any that is free
   * @param setting what {@link WorldDescription#of} says of the world
   * @throws SimulationException if it cannot listen there
   */
  public PageServer(String host, int port, String setting) {
    if (port < 0 || port > MAX_PORT) {
      throw new SimulationException(
          "page: port: between 0 and " + MAX_PORT + " expected, not " + port);
    }
    InetSocketAddress address = new InetSocketAddress(host, port);
    if (address.isUnresolved()) {
      throw new SimulationException("page: unknown host: " + host);
    }
    this.host = host;
    thread =
        new MultiThreadIoEventLoopGroup(
            1, new DefaultThreadFactory("page", true), NioIoHandler.newFactory());
    viewers = new Viewers(thread.next(), setting);
    boolean local = address.getAddress().isLoopbackAddress();
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
                    initPipeline(channel, local);
                  }
                })
            .bind(address)
            .awaitUninterruptibly();
    if (!opened.isSuccess()) {
      close();
      throw new SimulationException(whyNot(host, port, opened.cause()), opened.cause());
    }
    listening = opened.channel();
    bound = (InetSocketAddress) listening.localAddress();
    viewers.start();
  }

  private void initPipeline(SocketChannel channel, boolean local) {
    WebSocketServerProtocolConfig stream =
        WebSocketServerProtocolConfig.newBuilder()
            .websocketPath(PageFiles.STREAM)
            .maxFramePayloadLength(MAX_MESSAGE)
            .handshakeTimeoutMillis(HANDSHAKE_MILLISECONDS)
            .dropPongFrames(false)
            .build();
    channel
        .pipeline()
        .addLast(
            new IdleStateHandler(IDLE_SECONDS, 0, 0),
            new HttpServerCodec(),
            new HttpObjectAggregator(MAX_REQUEST),
            new PageFiles(local),
            new WebSocketServerProtocolHandler(stream),
            new ViewerHandler(viewers));
    viewers.connected(channel);
  }

  private static String whyNot(String host, int port, Throwable cause) {
    if (cause instanceof BindException && port > 0) {
      return "page: cannot use port "
          + port
          + " of "
          + host
          + ": "
          + cause.getMessage()
          + "; another program may have it, choose another one (0: any that is free)";
    }
    return "page: cannot listen on " + host + ":" + port + ": " + cause.getMessage();
  }

  /** The port on which it listens. */
  public int port() {
    return bound.getPort();
  }

  /** What to give to a browser. */
  public String url() {
    InetAddress address = bound.getAddress();
    String name =
        address.isLoopbackAddress() || address.isAnyLocalAddress()
            ? "localhost"
            : host.contains(":") ? "[" + host + "]" : host;
    return "http://" + name + ":" + port() + "/";
  }

  /** How many browsers are looking. */
  public int viewers() {
    return viewers.count();
  }

  /** Whether it is time to {@link #show} what there is now: somebody looks, and is ready. */
  public boolean isWaiting() {
    return viewers.isWaiting();
  }

  /** Shows a moment. Returns at once. */
  public void show(Snapshot moment) {
    viewers.show(moment);
  }

  /** Tells all browsers that the world, or what is shown of it, is another one. */
  public void describe(String setting) {
    viewers.describe(setting);
  }

  /** Leaves all browsers alone and frees the port. */
  @Override
  public void close() {
    if (thread.isShuttingDown()) {
      return;
    }
    if (listening != null) {
      listening.close().awaitUninterruptibly();
    }
    // A thread that is to end closes the connections first, and does nothing more for them.
    viewers.close().awaitUninterruptibly(CLOSE_SECONDS, TimeUnit.SECONDS);
    // The port is free when the thread has let go of the channel: somebody may want it at once.
    thread
        .shutdownGracefully(0, 1, TimeUnit.SECONDS)
        .awaitUninterruptibly(CLOSE_SECONDS, TimeUnit.SECONDS);
  }
}
