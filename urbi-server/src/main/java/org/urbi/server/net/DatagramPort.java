package org.urbi.server.net;

import io.netty.bootstrap.Bootstrap;
import io.netty.buffer.ByteBuf;
import io.netty.channel.Channel;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelOption;
import io.netty.channel.EventLoopGroup;
import io.netty.channel.FixedRecvByteBufAllocator;
import io.netty.channel.SimpleChannelInboundHandler;
import io.netty.channel.socket.DatagramPacket;
import io.netty.channel.socket.nio.NioDatagramChannel;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.log.WatchFailure;
import org.urbi.server.Trace;
import urbi.rtp.RtpSession;

/**
 * The UDP port of a server: each datagram goes to the connection whose token it contains; all
 * others are dropped. The port is opened when the first connection needs it. All work is done on
 * the network thread.
 */
final class DatagramPort {
  /** Receives datagrams. */
  interface Receiver {
    void receive(byte[] datagram, InetSocketAddress sender);
  }

  private record Request(Consumer<Channel> opened, Consumer<String> failed) {}

  private static final int MAX_SIZE = 1 << 16;
  private static final int BUFFER = 4 << 20;

  private final EventLoopGroup loop;
  private final Supplier<InetSocketAddress> server;
  private final Trace trace;
  private final Map<Long, Receiver> receivers = new HashMap<>();
  private final List<Request> waiting = new ArrayList<>();
  private final WatchFailure failure = new WatchFailure("taking datagrams");
  private @Nullable Channel channel;
  private boolean closed;
  private long refused;

  /**
   * @param server where it listens; the port is another one if that is taken
   */
  DatagramPort(EventLoopGroup loop, Supplier<InetSocketAddress> server, Trace trace) {
    this.loop = loop;
    this.server = server;
    this.trace = trace;
  }

  /**
   * Opens the port unless it is open, then calls one of the two. Who asks while it is being opened
   * is told in the order of asking: of a connection that asks again, the last request counts.
   */
  void open(Consumer<Channel> opened, Consumer<String> failed) {
    if (channel != null) {
      opened.accept(channel);
      return;
    }
    waiting.add(new Request(opened, failed));
    if (waiting.size() == 1) {
      InetSocketAddress same = server.get();
      InetSocketAddress any = new InetSocketAddress(same.getAddress(), 0);
      bind(same, refusal -> bind(any, this::failed));
    }
  }

  private void bind(InetSocketAddress where, Consumer<Throwable> otherwise) {
    ChannelFuture bound =
        new Bootstrap()
            .group(loop)
            .channel(NioDatagramChannel.class)
            .option(ChannelOption.SO_RCVBUF, BUFFER)
            .option(ChannelOption.SO_SNDBUF, BUFFER)
            .option(ChannelOption.RECVBUF_ALLOCATOR, new FixedRecvByteBufAllocator(MAX_SIZE))
            .handler(new Incoming())
            .bind(where);
    bound.addListener(done -> {
      if (done.isSuccess()) {
        opened(bound.channel());
      } else {
        otherwise.accept(done.cause());
      }
    });
  }

  private void opened(Channel bound) {
    if (closed) {
      bound.close();
      failed(new IOException(Problem.PORT_CLOSED.text()));
      return;
    }
    channel = bound;
    trace.debug("taking datagrams on " + bound.localAddress());
    answer(each -> each.opened.accept(bound));
  }

  private void failed(Throwable cause) {
    answer(
        each -> each.failed.accept(Problem.NO_DATAGRAMS.text(String.valueOf(cause.getMessage()))));
  }

  private void answer(Consumer<Request> answer) {
    List<Request> all = List.copyOf(waiting);
    waiting.clear();
    all.forEach(answer);
  }

  /** Sends datagrams with that token to a receiver from now on. */
  void add(long token, Receiver receiver) {
    receivers.put(token, receiver);
  }

  void remove(long token) {
    receivers.remove(token);
  }

  /** Closes the port, also one that is being opened: who waits for it is told. */
  void close() {
    loop.next()
        .execute(() -> {
          closed = true;
          if (channel != null) {
            channel.close();
          }
        });
  }

  private final class Incoming extends SimpleChannelInboundHandler<DatagramPacket> {
    @Override
    protected void channelRead0(ChannelHandlerContext context, DatagramPacket packet) {
      ByteBuf content = packet.content();
      byte[] bytes = new byte[content.readableBytes()];
      content.readBytes(bytes);
      Receiver receiver = receivers.get(RtpSession.token(bytes, bytes.length));
      if (receiver != null) {
        receiver.receive(bytes, packet.sender());
      } else if (refused++ == 0) {
        trace.debug("a stranger sends datagrams: " + packet.sender());
      }
    }

    @Override
    public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
      // A datagram could not be sent or received: it is lost, as any datagram may be.
      if (cause instanceof IOException) {
        trace.debug("a datagram is lost: " + cause.getMessage());
      } else {
        failure.met(cause);
      }
    }
  }
}
