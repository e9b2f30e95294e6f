package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelDuplexHandler;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelPromise;
import io.netty.util.concurrent.ScheduledFuture;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BiFunction;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Connection;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.outside.SocketSelector;
import org.urbi.kernel.remote.InputFailure;
import org.urbi.kernel.remote.RemotePeer;
import org.urbi.kernel.remote.RemoteTransport;
import org.urbi.server.Trace;
import urbi.rtp.RtpParameters;
import urbi.rtp.RtpSession;
import urbi.wire.Frame;
import urbi.wire.Protocol;
import urbi.wire.WireException;
import urbi.wire.WireInput;

/**
 * Handles a process with UObjects: splits its input into frames for the kernel, and sends the
 * kernel's frames. Its urbiscript code goes to the lobby of the connection, and the lobby's output
 * goes to the process.
 */
final class FrameHandler extends ChannelDuplexHandler implements RemoteTransport {
  private static final int HEADER = 4;
  private static final int MAX_AHEAD = 4 << 20;
  private static final int MAX_INPUT = 8 << 20;
  private static final long MAX_OUTPUT = 512L << 20;

  private static final byte[] PING = {0, 0, 0, 1, Frame.PING};
  private static final byte[] PONG = {0, 0, 0, 1, Frame.PONG};

  private final BiFunction<String, RemoteTransport, RemotePeer> peers;
  private final Trace trace;
  private final DatagramPort port;
  private final AtomicLong unconsumed = new AtomicLong();
  private ChannelHandlerContext context;
  private @Nullable ConsoleChannel bare;
  private FrameOutput output;
  private RemotePeer peer;
  private FrameDatagrams datagrams;
  private ByteBuf partial = Unpooled.EMPTY_BUFFER;
  private ScheduledFuture<?> watch;
  private final ReentrantLock reading = new ReentrantLock();
  private boolean kernelReads;
  private volatile boolean attended;
  private volatile long heard;
  private String reason = Problem.PROCESS_GONE.text();
  private volatile boolean over;

  /**
   * @param peers makes the kernel's side, of a name for people
   * @param port where datagrams come and go
   */
  FrameHandler(
      BiFunction<String, RemoteTransport, RemotePeer> peers, DatagramPort port, Trace trace) {
    this.port = port;
    this.peers = peers;
    this.trace = trace;
  }

  @Override
  public void handlerAdded(ChannelHandlerContext added) {
    context = added;
    bare = ConsoleChannel.bare(added);
    heard = added.executor().ticker().nanoTime();
    output = new FrameOutput(added, () -> peer.behind(), () -> peer.drained());
    datagrams = new FrameDatagrams(added.executor(), port, output::writeAndFlush, this::value);
    peer = peers.apply(String.valueOf(added.channel().id().asShortText()), this);
    watch = added.executor().scheduleWithFixedDelay(this::watch, 1, 1, TimeUnit.SECONDS);
    trace.debug("client has UObjects: " + added.channel().remoteAddress());
  }

  private void watch() {
    long silence = TimeUnit.NANOSECONDS.toSeconds(context.executor().ticker().nanoTime() - heard);
    if (silence >= Protocol.TIMEOUT_SECONDS) {
      close(Problem.PROCESS_SILENT.text());
    } else if (silence >= Protocol.SILENCE_SECONDS) {
      output.writeAndFlush(PING);
    }
    if (attended) {
      attended = false;
      peer.askForAttention();
    } else {
      stopReading();
    }
  }

  // ------------------------------------------------------------------ in

  @Override
  public void channelRead(ChannelHandlerContext from, Object message) {
    ByteBuf in = (ByteBuf) message;
    heard = from.executor().ticker().nanoTime();
    if (partial.isReadable()) {
      partial.writeBytes(in);
      in.release();
      in = partial;
      partial = Unpooled.EMPTY_BUFFER;
    }
    try {
      read(in);
    } catch (WireException e) {
      broken(e);
    } finally {
      keepPartialFrame(in);
    }
    if (unconsumed.get() > MAX_INPUT) {
      from.channel().config().setAutoRead(false);
      consumed(0);
    }
  }

  private void broken(RuntimeException e) {
    over = true;
    close(InputFailure.text(e));
  }

  private void read(ByteBuf in) {
    while (!over && in.readableBytes() > HEADER) {
      int length = in.getInt(in.readerIndex());
      if (length < 1 || length > Protocol.MAX_FRAME) {
        throw new WireException(Problem.LONG_FRAME.text(length));
      }
      if (in.readableBytes() < HEADER + length) {
        return;
      }
      in.skipBytes(HEADER);
      frame(in, length);
    }
  }

  private void frame(ByteBuf in, int length) {
    int type = in.getUnsignedByte(in.readerIndex());
    switch (type) {
      case Frame.PING -> {
        in.skipBytes(length);
        output.writeAndFlush(PONG);
      }
      case Frame.PONG -> in.skipBytes(length);
      case Frame.CODE -> {
        in.skipBytes(1);
        context.fireChannelRead(in.readRetainedSlice(length - 1));
      }
      case Frame.LEFT, Frame.RTP_ACTIVE -> {
        byte[] bytes = new byte[length];
        in.readBytes(bytes);
        aboutDatagrams(new WireInput(bytes, 0, length));
      }
      default -> {
        byte[] bytes = new byte[length];
        in.readBytes(bytes);
        receive(bytes);
      }
    }
  }

  private void receive(byte[] frame) {
    unconsumed.addAndGet(frame.length);
    peer.receive(frame);
  }

  private void aboutDatagrams(WireInput in) {
    int type = in.octet();
    RtpSession session = datagrams.session();
    if (session == null) {
      return;
    }
    if (type == Frame.LEFT) {
      session.left(in);
    } else {
      session.setActive(in.octet() == 1);
    }
  }

  // ------------------------------------------------------------------ in, by the kernel

  @Override
  public void wantToRead() {
    ConsoleChannel own = bare;
    if (own != null) {
      NetworkThread.execute(context.executor(), () -> leaveReading(own));
    }
  }

  private void leaveReading(ConsoleChannel own) {
    if (!over && !partial.isReadable() && own.config().isAutoRead()) {
      own.leaveReading();
      reading.lock();
      kernelReads = true;
      reading.unlock();
      attended = true;
      peer.mayRead(new SocketSelector.Socket(own.socketChannel()));
    }
  }

  @Override
  public void attended() {
    attended = true;
  }

  @Override
  public void stopReading() {
    reading.lock();
    try {
      if (kernelReads) {
        resumeReading(new byte[0]);
      }
    } finally {
      reading.unlock();
    }
  }

  /**
   * Makes the network thread read again, starting with the bytes that the kernel thread has read
   * but cannot use.
   */
  private void resumeReading(byte[] rest) {
    kernelReads = false;
    NetworkThread.execute(
        context.executor(),
        () -> {
          if (rest.length > 0 && !over) {
            channelRead(context, context.alloc().buffer(rest.length).writeBytes(rest));
          }
          ((ConsoleChannel) context.channel()).resumeReading();
        });
  }

  @Override
  public boolean read(ByteBuffer space) {
    reading.lock();
    try {
      if (!kernelReads) {
        return false;
      }
      space.clear();
      int size = ((ConsoleChannel) context.channel()).socketChannel().read(space);
      if (size != 0) {
        heard = context.executor().ticker().nanoTime();
        space.flip();
        receiveAll(space);
        if (size < 0 || space.hasRemaining() || unconsumed.get() > MAX_INPUT) {
          byte[] rest = new byte[space.remaining()];
          space.get(rest);
          resumeReading(rest);
        }
      }
    } catch (IOException e) {
      // The network thread will get the same error.
      resumeReading(new byte[0]);
    } catch (RuntimeException e) {
      // No input of a process may end the kernel thread.
      broken(e);
      resumeReading(new byte[0]);
    } finally {
      reading.unlock();
    }
    return kernelReads;
  }

  /** Takes complete frames for the kernel; stops at the first other one. */
  private void receiveAll(ByteBuffer in) {
    while (in.remaining() > HEADER) {
      int length = in.getInt(in.position());
      boolean whole = length >= 1 && length <= in.remaining() - HEADER;
      if (!whole || !isForKernel(in.get(in.position() + HEADER))) {
        return;
      }
      byte[] frame = new byte[length];
      in.position(in.position() + HEADER).get(frame);
      receive(frame);
    }
  }

  private static boolean isForKernel(int type) {
    return switch (type) {
      case Frame.PING, Frame.PONG, Frame.CODE, Frame.LEFT, Frame.RTP_ACTIVE -> false;
      default -> true;
    };
  }

  // ------------------------------------------------------------------ in, by datagrams

  /** Takes a value from datagrams. While the kernel is busy, such values are dropped. */
  private void value(byte[] frame) {
    if (over || unconsumed.get() > MAX_INPUT || frame[0] != Frame.SET) {
      return;
    }
    try {
      WireInput in = new WireInput(frame, 1, frame.length);
      in.size();
      in.value();
    } catch (WireException e) {
      trace.debug("a datagram makes no sense: " + e.getMessage());
      return;
    }
    receive(frame);
  }

  /** Keeps the beginning of an incomplete frame. */
  private void keepPartialFrame(ByteBuf in) {
    if (over || !in.isReadable()) {
      in.release();
      return;
    }
    // A slice of another buffer cannot grow.
    if (in.refCnt() == 1 && !in.isReadOnly() && in.maxCapacity() == Integer.MAX_VALUE) {
      partial = in.discardReadBytes();
    } else {
      partial = context.alloc().buffer(in.readableBytes()).writeBytes(in);
      in.release();
    }
    if (partial.readableBytes() >= HEADER) {
      // Allocates only a little at once: the announced length of the frame may be a lie.
      long missing =
          HEADER + (long) partial.getInt(partial.readerIndex()) - partial.readableBytes();
      partial.ensureWritable(Math.clamp(missing, 0, MAX_AHEAD));
    }
  }

  @Override
  public void consumed(int bytes) {
    if (unconsumed.addAndGet(-bytes) <= MAX_INPUT / 2) {
      var config = context.channel().config();
      if (!config.isAutoRead()) {
        config.setAutoRead(true);
      }
    }
  }

  @Override
  public void channelInactive(ChannelHandlerContext gone) {
    over = true;
    watch.cancel(false);
    datagrams.lost();
    peer.lost(reason);
    gone.fireChannelInactive();
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext removed) {
    partial.release();
    partial = Unpooled.EMPTY_BUFFER;
  }

  @Override
  public int console() {
    ConsoleHandler console = context.pipeline().get(ConsoleHandler.class);
    Connection lobby = console == null ? null : console.connection();
    return lobby == null ? RemoteTransport.super.console() : lobby.number();
  }

  // ------------------------------------------------------------------ out

  /** Sends the output of the lobby. */
  @Override
  public void write(ChannelHandlerContext to, Object message, ChannelPromise promise) {
    ByteBuf text = (ByteBuf) message;
    ByteBuf header = to.alloc().buffer(HEADER + 1);
    header.writeInt(text.readableBytes() + 1).writeByte(Frame.OUTPUT);
    output.write(promise, header, text);
  }

  @Override
  public void send(byte[] frames) {
    if (output.unsent() > MAX_OUTPUT) {
      close(Problem.PROCESS_DOES_NOT_READ.text());
    } else {
      output.send(frames);
    }
  }

  @Override
  public void openDatagrams(RtpParameters terms) {
    if (bare == null) {
      datagrams.refuse(Problem.DATAGRAMS_NOT_SAFE.text());
    } else {
      datagrams.open(terms);
    }
  }

  @Override
  public @Nullable RtpSession datagrams() {
    return datagrams.session();
  }

  @Override
  public void closeDatagrams() {
    datagrams.close();
  }

  @Override
  public void close(String why) {
    NetworkThread.execute(
        context.executor(),
        () -> {
          reason = why;
          trace.debug("client lost: " + context.channel().remoteAddress() + ": " + why);
          context.close();
        });
  }
}
