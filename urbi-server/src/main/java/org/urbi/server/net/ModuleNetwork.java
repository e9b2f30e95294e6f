package org.urbi.server.net;

import io.netty.bootstrap.ServerBootstrap;
import io.netty.buffer.ByteBuf;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInitializer;
import io.netty.channel.ChannelOption;
import io.netty.channel.EventLoopGroup;
import io.netty.channel.SimpleChannelInboundHandler;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.remote.RemotePeer;
import org.urbi.kernel.time.SystemClock;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;
import org.urbi.server.Version;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.TokenThrottle;
import org.urbi.server.trust.Tokens;
import org.urbi.web.NetworkLoop;

/**
 * The connections of processes that the server has started for modules. Each gets a port of its
 * own, of this machine only, and a token that nobody else knows; the port is closed when the
 * process has connected.
 */
public final class ModuleNetwork implements AutoCloseable {
  private static final int TOKEN_BYTES = 32;

  private final Trace trace;
  private @Nullable EventLoopGroup loop;
  private boolean closed;

  public ModuleNetwork(Trace trace) {
    this.trace = trace;
  }

  /** Where one process may connect. */
  public final class Entrance implements AutoCloseable {
    private final String token;
    private final RemotePeer peer;
    private final AccessPolicy policy;
    private final DatagramPort datagrams;
    private final Channel listener;
    private volatile @Nullable Channel connection;

    private Entrance(RemotePeer peer, EventLoopGroup group) throws IOException {
      this.peer = peer;
      byte[] secret = new byte[TOKEN_BYTES];
      // Made here, because few servers need one, and it loads all security providers.
      new SecureRandom().nextBytes(secret);
      token = HexFormat.of().formatHex(secret);
      policy = new AccessPolicy(Tokens.single(token, Role.OWNER, "a module"), null);
      InetAddress here = InetAddress.getLoopbackAddress();
      datagrams = new DatagramPort(group, () -> new InetSocketAddress(here, 0), trace);
      ChannelFuture bound =
          new ServerBootstrap()
              .group(group)
              .channelFactory(ConsoleListener::new)
              .handler(new AcceptFailures(trace))
              .childOption(ChannelOption.TCP_NODELAY, true)
              .childHandler(
                  new ChannelInitializer<>() {
                    @Override
                    protected void initChannel(Channel client) {
                      handle(client);
                    }
                  })
              .bind(new InetSocketAddress(here, 0))
              .awaitUninterruptibly();
      if (!bound.isSuccess()) {
        throw new IOException(bound.cause().getMessage(), bound.cause());
      }
      listener = bound.channel();
    }

    /** Nobody is punished for a wrong token, which could keep the process out. */
    private void handle(Channel client) {
      client
          .pipeline()
          .addLast(
              new TokenAuthenticator(policy, new TokenThrottle(new SystemClock()), trace),
              new ProtocolDetector(() -> admit(client), Version.number()),
              // No module asks as telnet does.
              new TelnetDecoder(answer -> {}),
              new SimpleChannelInboundHandler<ByteBuf>() {
                @Override
                protected void channelRead0(ChannelHandlerContext context, ByteBuf code) {
                  peer.code(code.toString(StandardCharsets.UTF_8));
                }

                @Override
                public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
                  if (cause instanceof IOException) {
                    trace.debug("a module's connection is lost: " + cause);
                  } else {
                    FailureLog.internal("the connection of a module", cause);
                    peer.lost(FailureLog.text(cause));
                  }
                  context.close();
                }
              });
    }

    private FrameHandler admit(Channel client) {
      connection = client;
      listener.close();
      // Nobody else uses it: each process would leave a descriptor.
      client.closeFuture().addListener(done -> datagrams.close());
      return new FrameHandler(
          (name, transport) -> {
            peer.connected(transport);
            return peer;
          },
          datagrams,
          trace);
    }

    /** The port of this machine where the process is to connect. */
    public int port() {
      return ((InetSocketAddress) listener.localAddress()).getPort();
    }

    /** What it is to show there. */
    public String token() {
      return token;
    }

    @Override
    public void close() {
      listener.close();
      Channel open = connection;
      if (open != null) {
        open.close();
      }
    }
  }

  /**
   * Lets one process connect.
   *
   * @param peer the kernel's side of it
   * @throws IOException if the machine does not allow it
   */
  public Entrance open(RemotePeer peer) throws IOException {
    return new Entrance(peer, loop());
  }

  private synchronized EventLoopGroup loop() throws IOException {
    if (closed) {
      throw new IOException("the server has ended");
    }
    if (loop == null) {
      loop = NetworkLoop.group("urbi-modules", FailureLog::internal);
    }
    return loop;
  }

  @Override
  public synchronized void close() {
    closed = true;
    if (loop != null) {
      loop.shutdownGracefully(0, 1, TimeUnit.SECONDS);
    }
  }
}
