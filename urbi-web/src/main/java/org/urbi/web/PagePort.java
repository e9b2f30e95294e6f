package org.urbi.web;

import io.netty.bootstrap.ServerBootstrap;
import io.netty.buffer.Unpooled;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelHandler;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInitializer;
import io.netty.channel.ChannelOption;
import io.netty.channel.ChannelPipeline;
import io.netty.channel.EventLoop;
import io.netty.channel.EventLoopGroup;
import io.netty.channel.group.ChannelGroup;
import io.netty.channel.group.DefaultChannelGroup;
import io.netty.channel.socket.SocketChannel;
import io.netty.channel.socket.nio.NioServerSocketChannel;
import io.netty.handler.codec.http.DefaultFullHttpResponse;
import io.netty.handler.codec.http.FullHttpResponse;
import io.netty.handler.codec.http.HttpMessage;
import io.netty.handler.codec.http.HttpObjectAggregator;
import io.netty.handler.codec.http.HttpResponseStatus;
import io.netty.handler.codec.http.HttpServerCodec;
import io.netty.handler.codec.http.HttpUtil;
import io.netty.handler.codec.http.HttpVersion;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketCloseStatus;
import io.netty.handler.codec.http.websocketx.WebSocketServerProtocolHandler;
import io.netty.handler.ssl.SslContext;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** Where browsers get a page and its stream, with one thread for all of them. */
public final class PagePort implements AutoCloseable {
  private static final int MAX_REQUEST = 1 << 13;
  private static final int CLOSE_SECONDS = 2;

  private final EventLoopGroup thread;
  private final ChannelGroup connections;

  private final boolean open;
  private final Places places = new Places();
  private final PageShelf shelf = new PageShelf();
  private final Downloads downloads;
  private @Nullable Channel listening;
  private String scheme = "http";
  private String host = "";

  /**
   * Serves nobody before {@link #listen}.
   *
   * @param name of its thread
   * @param open whether somebody is let in without a token
   */
  public PagePort(String name, boolean open) {
    this.open = open;
    thread = NetworkLoop.group(name, StreamFailure::log);
    connections = new DefaultChannelGroup(thread.next());
    downloads = new Downloads(thread.next(), places);
  }

  /** Who looks, and who waits for that; for the thread that serves all browsers. */
  public Places places() {
    return places;
  }

  /** What is offered to owners besides; for the same thread. */
  public Downloads downloads() {
    return downloads;
  }

  /** The thread that serves all browsers. */
  public EventLoop thread() {
    return thread.next();
  }

  /**
   * Begins to serve.
   *
   * @param address where; port 0 is any that is free
   * @param tls with what the connections are encrypted, or {@code null}
   * @param viewer makes what handles the WebSocket frames of a browser
   * @param guests who else may come, or {@code null}
   * @param entrance to pages of components that are served here, too, or {@code null}
   * @throws IOException if it cannot listen there; then it is closed
   */
  public void listen(
      InetSocketAddress address,
      @Nullable SslContext tls,
      Page page,
      Supplier<ChannelHandler> viewer,
      @Nullable Guests guests,
      @Nullable Entrance entrance)
      throws IOException {
    scheme = tls == null ? "http" : "https";
    host = address.getHostString();
    HostNames names = new HostNames(address.getAddress().isLoopbackAddress(), host, open);
    ChannelFuture opened =
        new ServerBootstrap()
            .group(thread)
            .channel(NioServerSocketChannel.class)
            .option(ChannelOption.SO_REUSEADDR, true)
            .childOption(ChannelOption.TCP_NODELAY, true)
            .childOption(ChannelOption.WRITE_BUFFER_WATER_MARK, page.backlog())
            .childHandler(
                new ChannelInitializer<SocketChannel>() {
                  @Override
                  protected void initChannel(SocketChannel channel) {
                    places.arrive(channel);
                    connections.add(channel);
                    if (tls != null) {
                      channel.pipeline().addLast(tls.newHandler(channel.alloc()));
                    }
                    serve(
                        channel,
                        page,
                        new PageFiles(
                            page, shelf, names, tls != null, downloads, viewer, guests, entrance));
                  }
                })
            .bind(address)
            .awaitUninterruptibly();
    if (!opened.isSuccess()) {
      close();
      throw new IOException(opened.cause().getMessage(), opened.cause());
    }
    listening = opened.channel();
  }

  /** Makes requests of the bytes of a connection, and hands them on. */
  static void serve(Channel channel, Page page, PageFiles files) {
    channel
        .pipeline()
        .addLast(new HttpServerCodec(), new Requests(), new Silence(page.silence()), files);
  }

  /**
   * Makes one request of its parts. Whoever sends a longer one is told so, and not listened to
   * until all of it has come.
   */
  private static final class Requests extends HttpObjectAggregator {
    Requests() {
      super(MAX_REQUEST, true);
    }

    @Override
    protected void handleOversizedMessage(ChannelHandlerContext context, HttpMessage oversized) {
      FullHttpResponse answer =
          new DefaultFullHttpResponse(
              HttpVersion.HTTP_1_1,
              HttpResponseStatus.REQUEST_ENTITY_TOO_LARGE,
              Unpooled.EMPTY_BUFFER);
      HttpUtil.setContentLength(answer, 0);
      HttpUtil.setKeepAlive(answer, false);
      Farewell.say(context.channel(), answer);
    }
  }

  /** Makes frames of what comes from now on, instead of requests. */
  static void serveStream(
      ChannelPipeline pipeline,
      String path,
      @Nullable String subprotocols,
      int longestMessage,
      ChannelHandler viewer) {
    pipeline.addLast(
        new StreamProtocol(path, subprotocols, longestMessage),
        new StreamProtocol.Messages(longestMessage),
        viewer);
  }

  /** Whether a connection has become a stream: {@link PageFiles} has passed it on, and gone. */
  static boolean isStream(Channel channel) {
    return channel.pipeline().get(WebSocketServerProtocolHandler.class) != null
        && channel.pipeline().get(PageFiles.class) == null;
  }

  private InetSocketAddress bound() {
    if (listening == null) {
      throw new IllegalStateException("nobody is served yet");
    }
    return (InetSocketAddress) listening.localAddress();
  }

  /** The port on which it listens. */
  public int port() {
    return bound().getPort();
  }

  /** What to give to a browser. */
  public String url() {
    InetAddress where = bound().getAddress();
    String name =
        where.isLoopbackAddress() || where.isAnyLocalAddress()
            ? "localhost"
            : host.contains(":") ? "[" + host + "]" : host;
    return scheme + "://" + name + ":" + port() + "/";
  }

  /** Says goodbye to all browsers, and frees the port. */
  @Override
  public void close() {
    if (thread.isShuttingDown()) {
      return;
    }
    if (listening != null) {
      listening.close().awaitUninterruptibly();
    }
    // A thread that is to end closes the connections first, and does nothing more for them.
    thread().submit(this::sayGoodbye).awaitUninterruptibly(CLOSE_SECONDS, TimeUnit.SECONDS);
    // The port is free when the thread has let go of the channel: somebody may want it at once.
    thread
        .shutdownGracefully(0, 1, TimeUnit.SECONDS)
        .awaitUninterruptibly(CLOSE_SECONDS, TimeUnit.SECONDS);
  }

  private void sayGoodbye() {
    connections.writeAndFlush(
        new CloseWebSocketFrame(WebSocketCloseStatus.ENDPOINT_UNAVAILABLE), PagePort::isStream);
    connections.close();
  }
}
